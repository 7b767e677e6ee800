package majic.link;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.security.NoSuchAlgorithmException;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.SSLSocketFactory;

/** Encrypts a connection by TLS, as a client that checks the server's certificate and name. */
final class TlsLayer implements TcpLink.Layer {
    private final String host;
    private final int port;

    TlsLayer(String host, int port) {
        this.host = host;
        this.port = port;
    }

    @Override
    public Socket over(Socket connected, int timeoutMs) throws IOException {
        SSLSocketFactory factory = defaultContext().getSocketFactory();
        SSLSocket secure = (SSLSocket) factory.createSocket(connected, host, port, true);
        SSLParameters parameters = secure.getSSLParameters();
        parameters.setEndpointIdentificationAlgorithm("HTTPS");
        secure.setSSLParameters(parameters);
        secure.setSoTimeout(timeoutMs);
        try {
            secure.startHandshake();
        } catch (SocketTimeoutException e) {
            SocketTimeoutException explained = new SocketTimeoutException(
                    host + " port " + port + " was reached, but began no TLS within " + timeoutMs / 1000.0 + " s");
            explained.initCause(e);
            throw explained;
        }
        secure.setSoTimeout(0);
        return secure;
    }

    private static SSLContext defaultContext() throws SSLException {
        try {
            return SSLContext.getDefault();
        } catch (NoSuchAlgorithmException e) {
            throw new SSLException("the trust store of this Java cannot be used: " + e.getMessage(), e);
        }
    }
}

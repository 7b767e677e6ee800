package majic.link;

import java.io.IOException;
import java.net.Socket;
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
        SSLSocketFactory factory = (SSLSocketFactory) SSLSocketFactory.getDefault();
        SSLSocket secure = (SSLSocket) factory.createSocket(connected, host, port, true);
        SSLParameters parameters = secure.getSSLParameters();
        parameters.setEndpointIdentificationAlgorithm("HTTPS");
        secure.setSSLParameters(parameters);
        secure.setSoTimeout(timeoutMs);
        secure.startHandshake();
        secure.setSoTimeout(0);
        return secure;
    }
}

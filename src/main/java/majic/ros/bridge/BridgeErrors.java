package majic.ros.bridge;

import java.io.IOException;
import java.security.cert.CertificateException;
import javax.net.ssl.SSLException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.ros.websocket.NotWebSocket;
import org.jspecify.annotations.Nullable;

/** Explains why there is no connection to a rosbridge server. */
final class BridgeErrors {
    private BridgeErrors() {}

    static ConnectFailed explained(IOException failure, BridgeAddress address) {
        String where = address.host() + " port " + address.port();
        if (failure instanceof NotWebSocket other) {
            return new ConnectFailed(Reason.WRONG_DEVICE, notRosbridge(other, where, address), failure);
        }
        CertificateException certificate = certificate(failure);
        if (certificate != null) {
            return new ConnectFailed(
                    Reason.NOT_ALLOWED,
                    "the certificate of " + where + " is not trusted (" + certificate.getMessage()
                            + "); it must be issued for " + address.host()
                            + " and be in the trust store of this Java (keytool -importcert)",
                    failure);
        }
        if (failure instanceof SSLException) {
            return new ConnectFailed(
                    Reason.WRONG_DEVICE,
                    where + " was reached, but TLS failed (" + failure.getMessage()
                            + "); a server without TLS is added as ros://" + address.hostAndPort(),
                    failure);
        }
        return ConnectFailed.of(failure);
    }

    private static @Nullable CertificateException certificate(Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (cause instanceof CertificateException certificate) {
                return certificate;
            }
        }
        return null;
    }

    private static String notRosbridge(NotWebSocket other, String where, BridgeAddress address) {
        String line = other.line();
        if (other.isWebServer()) {
            return where + " is a web server, but no rosbridge server: it answers \"" + line
                    + "\"; the port of rosbridge is usually " + BridgeAddress.PORT;
        }
        if (line != null) {
            return where + " does not answer as a rosbridge server does: it sends \"" + line
                    + "\"; the port of rosbridge is usually " + BridgeAddress.PORT;
        }
        return where + " closed the connection at once; is it the port of a rosbridge server"
                + (address.secure() ? "?" : " without TLS? One with TLS is added as ross://" + address.hostAndPort());
    }
}

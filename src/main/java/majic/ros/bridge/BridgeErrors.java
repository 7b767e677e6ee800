package majic.ros.bridge;

import java.io.IOException;
import java.net.SocketTimeoutException;
import java.security.GeneralSecurityException;
import javax.net.ssl.SSLException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.ros.websocket.NotWebSocket;
import majic.text.Advice;
import org.jspecify.annotations.Nullable;

/** Explains why there is no connection to a rosbridge server. */
final class BridgeErrors {
    private BridgeErrors() {}

    static ConnectFailed explained(IOException failure, BridgeAddress address) {
        String where = address.host() + " port " + address.port();
        if (failure instanceof NotWebSocket other) {
            return new ConnectFailed(Reason.WRONG_DEVICE, notRosbridge(other, where, address), failure);
        }
        Throwable untrusted = untrusted(failure);
        if (untrusted != null) {
            return new ConnectFailed(
                    Reason.NOT_ALLOWED,
                    "the certificate of " + where + " is not trusted (" + untrusted.getMessage()
                            + "); is it issued for " + address.host()
                            + " and in the trust store of this Java (keytool -importcert -cacerts -alias "
                            + address.host() + " -file CERTIFICATE.pem)?",
                    failure);
        }
        if (failure instanceof SSLException) {
            return new ConnectFailed(
                    Reason.WRONG_DEVICE,
                    where + " was reached, but TLS failed (" + failure.getMessage() + "); "
                            + (speaksTls(failure)
                                    ? "does the server accept the TLS of this Java without a client certificate?"
                                    : withoutTls(address)),
                    failure);
        }
        if (address.secure() && failure instanceof SocketTimeoutException) {
            return ConnectFailed.of(failure, Advice.joined(failure.getMessage(), withoutTls(address)));
        }
        return ConnectFailed.of(failure);
    }

    private static String withoutTls(BridgeAddress address) {
        return "is it a server without TLS, which is added as ros://" + address.hostAndPort() + "?";
    }

    /** An alert is an answer in TLS. */
    private static boolean speaksTls(IOException failure) {
        return String.valueOf(failure.getMessage()).contains("alert");
    }

    /** Returns why the certificate is not trusted: it is wrong, or this Java has no trust store that can be used. */
    private static @Nullable Throwable untrusted(Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (cause instanceof GeneralSecurityException) {
                return cause;
            }
        }
        return null;
    }

    private static String notRosbridge(NotWebSocket other, String where, BridgeAddress address) {
        String line = other.line();
        if (other.isWebServer()) {
            return where + " is a web server, but no rosbridge server: it answers \"" + line
                    + "\"; is it the port of rosbridge, usually " + BridgeAddress.PORT + "?";
        }
        if (line != null) {
            return where + " does not answer as a rosbridge server does: it sends \"" + line
                    + "\"; is it the port of rosbridge, usually " + BridgeAddress.PORT + "?";
        }
        return where + " closed the connection at once; is it the port of a rosbridge server"
                + (address.secure()
                        ? "?"
                        : " without TLS, or of one with TLS, which is added as ross://" + address.hostAndPort() + "?");
    }
}

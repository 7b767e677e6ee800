package majic.shared.broker;

import com.hivemq.client.mqtt.exceptions.ConnectionClosedException;
import com.hivemq.client.mqtt.exceptions.MqttDecodeException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5ConnAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5DisconnectException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5PubAckException;
import com.hivemq.client.mqtt.mqtt5.exceptions.Mqtt5SubAckException;
import com.hivemq.client.mqtt.mqtt5.message.Mqtt5ReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.connect.connack.Mqtt5ConnAck;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeoutException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLHandshakeException;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;

/** What the client library throws, in sentences for the user. */
final class HiveErrors {
    /** Alerts of a broker that requires a certificate of its clients, or another one. */
    private static final Pattern REFUSED_CERTIFICATE =
            Pattern.compile("Received fatal alert: (\\w*certificate\\w*|unknown_ca)");

    private HiveErrors() {}

    /** Explains why a connection was not made. */
    static ConnectFailed connectFailed(BrokerAddress address, Throwable failure) {
        Optional<Mqtt5ConnAckException> refused = cause(failure, Mqtt5ConnAckException.class);
        if (refused.isPresent()) {
            return refused(address, refused.get().getMqttMessage(), failure);
        }
        if (cause(failure, SSLException.class).isPresent()) {
            return tls(address, failure);
        }
        if (isTimeout(failure)) {
            return noAnswer(address, failure);
        }
        if (cause(failure, Mqtt5DisconnectException.class).isPresent()) {
            return new ConnectFailed(
                    Reason.WRONG_DEVICE,
                    address.withPort()
                            + ": what answers at this port is no broker that speaks MQTT 5; is the port right, and the"
                            + " broker new enough?",
                    failure);
        }
        return closed(address, failure);
    }

    /** The port was reached, but nothing answered. */
    static ConnectFailed noAnswer(BrokerAddress address, Throwable failure) {
        return new ConnectFailed(
                Reason.NO_ANSWER,
                address.withPort()
                        + ": the port was reached, but no broker answers there; is the port right, or does it need "
                        + otherScheme(address),
                failure);
    }

    private static ConnectFailed closed(BrokerAddress address, Throwable failure) {
        boolean byBroker = cause(failure, ConnectionClosedException.class).isPresent();
        return new ConnectFailed(
                byBroker ? Reason.WRONG_DEVICE : Reason.OTHER,
                address.withPort()
                        + ": the connection was closed before a broker answered; is this the port of a broker for MQTT 5, or does it need "
                        + otherScheme(address),
                failure);
    }

    private static String otherScheme(BrokerAddress address) {
        return address.secure() ? "mqtt:// (without TLS)?" : "mqtts:// (with TLS)?";
    }

    private static ConnectFailed refused(BrokerAddress address, Mqtt5ConnAck answer, Throwable failure) {
        String said = answer.getReasonString().map(text -> " (" + text + ")").orElse("");
        return switch (answer.getReasonCode()) {
            case BAD_USER_NAME_OR_PASSWORD, NOT_AUTHORIZED, BAD_AUTHENTICATION_METHOD, BANNED ->
                new ConnectFailed(
                        Reason.WRONG_LOGIN,
                        address.withPort() + ": the broker refuses the user name or the password" + said
                                + "; are they in the file brokers.properties of the user's folder, or in the environment"
                                + " as MAJIC_MQTT_USER and MAJIC_MQTT_PASSWORD?",
                        failure);
            case UNSUPPORTED_PROTOCOL_VERSION ->
                new ConnectFailed(
                        Reason.WRONG_DEVICE,
                        address.withPort() + ": the broker does not speak MQTT 5" + said + "; use a newer one",
                        failure);
            case SERVER_BUSY, SERVER_UNAVAILABLE, QUOTA_EXCEEDED, CONNECTION_RATE_EXCEEDED ->
                new ConnectFailed(
                        Reason.BUSY, address.withPort() + ": the broker is busy" + said + "; try again later", failure);
            default ->
                new ConnectFailed(
                        Reason.OTHER,
                        address.withPort() + ": the broker refuses the connection: " + words(answer.getReasonCode())
                                + said,
                        failure);
        };
    }

    private static ConnectFailed tls(BrokerAddress address, Throwable failure) {
        Matcher alert = REFUSED_CERTIFICATE.matcher(innermost(failure));
        if (alert.matches()) {
            return new ConnectFailed(
                    Reason.OTHER,
                    address.withPort() + ": " + refusedCertificate(alert.group(1))
                            + "; is the file with the certificate and its key named in the file brokers.properties, as"
                            + " broker." + address.host() + ".key-store=FILE.p12?",
                    failure);
        }
        if (cause(failure, SSLHandshakeException.class).isPresent()) {
            return new ConnectFailed(
                    Reason.OTHER,
                    address.withPort() + ": no trusted TLS connection: " + innermost(failure)
                            + "; is a certificate that this computer does not know named in the file brokers.properties, as"
                            + " broker." + address.host() + ".ca=FILE.pem?",
                    failure);
        }
        return new ConnectFailed(
                Reason.WRONG_DEVICE,
                address.withPort() + ": the port speaks no TLS; is the port right, or is the address mqtt://"
                        + address.host() + ":" + address.port() + "/" + address.site() + "?",
                failure);
    }

    private static String refusedCertificate(String alert) {
        return switch (alert) {
            case "certificate_required" ->
                "the broker requires a client certificate that it trusts, and none was found";
            case "certificate_expired" -> "the client certificate has expired or is not valid yet; make a new one";
            case "certificate_revoked" -> "the client certificate has been revoked; ask for a new one";
            default -> "the broker requires a client certificate that it trusts (" + alert + ")";
        };
    }

    /** Says how a connection was lost, as half a sentence. */
    static String lost(Throwable failure) {
        if (isMalformed(failure)) {
            return "the broker has sent something malformed: " + innermost(failure);
        }
        Optional<Mqtt5DisconnectException> told = cause(failure, Mqtt5DisconnectException.class);
        if (told.isPresent() && !isTimeout(failure)) {
            return "the broker ended the connection: "
                    + words(told.get().getMqttMessage().getReasonCode());
        }
        return isTimeout(failure) ? "the broker does not answer" : "the broker closed the connection";
    }

    /** Returns why a message was not published: a refusal of the broker, or the reason of the system. */
    static BotException notPublished(BrokerMessage message, Throwable failure) {
        return cause(failure, Mqtt5PubAckException.class)
                .<BotException>map(refused -> new PublicationRefused(
                        message.topic(), words(refused.getMqttMessage().getReasonCode())))
                .orElseGet(() -> new BotException(
                        "the broker did not take the message on " + message.topic() + ": " + innermost(failure),
                        failure));
    }

    /** Returns why the broker refuses a subscription, as it words it; empty if it has not answered. */
    static Optional<String> notSubscribed(Throwable failure) {
        return cause(failure, Mqtt5SubAckException.class)
                .map(refused -> refused.getMqttMessage().getReasonCodes().get(0))
                .map(HiveErrors::words);
    }

    /** Returns whether a session has ended because of what the broker has sent. */
    static boolean isMalformed(Throwable failure) {
        return cause(failure, MqttDecodeException.class).isPresent();
    }

    private static String words(Mqtt5ReasonCode code) {
        return code.toString().replace('_', ' ').toLowerCase(Locale.ROOT);
    }

    private static boolean isTimeout(Throwable failure) {
        return cause(failure, TimeoutException.class).isPresent()
                || String.valueOf(failure.getMessage()).startsWith("Timeout");
    }

    /** Returns the innermost reason, as the system words it. */
    private static String innermost(Throwable failure) {
        Throwable innermost = failure;
        while (innermost.getCause() != null) {
            innermost = innermost.getCause();
        }
        return String.valueOf(innermost.getMessage());
    }

    private static <T extends Throwable> Optional<T> cause(Throwable failure, Class<T> type) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (type.isInstance(cause)) {
                return Optional.of(type.cast(cause));
            }
        }
        return Optional.empty();
    }
}

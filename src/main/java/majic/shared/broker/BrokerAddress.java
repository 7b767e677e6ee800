package majic.shared.broker;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotException;

/**
 * Where a broker is, and the path below which its topics are: {@code mqtt://host[:1883]/site}, or
 * {@code mqtts://host[:8883]/site} with TLS. Immutable.
 *
 * @param secure whether the connection uses TLS
 * @param host the name or address of the broker's computer; IPv6 in brackets
 * @param port its TCP port, 1 to 65535
 * @param site one or more levels with slashes between them, such as {@code lab} or {@code school/lab}
 */
public record BrokerAddress(boolean secure, String host, int port, String site) {
    /** The scheme without TLS. */
    public static final String SCHEME = "mqtt";

    /** The scheme with TLS. */
    public static final String SECURE_SCHEME = "mqtts";

    /** The usual port without TLS. */
    public static final int PORT = 1883;

    /** The usual port with TLS. */
    public static final int SECURE_PORT = 8883;

    private static final Pattern FORM = Pattern.compile(
            "(mqtts?)://(\\[[0-9a-fA-F:.]+]|[\\w.-]+)(?::(\\d{1,5}))?/([\\w.-]+(?:/[\\w.-]+)*)/?",
            Pattern.CASE_INSENSITIVE);
    private static final Pattern WITH_USER = Pattern.compile("[^/]*//[^/]*@.*");
    private static final int LARGEST_PORT = 65_535;

    /**
     * Reads an address. A slash at its end changes nothing.
     *
     * @param text as typed
     * @return the address
     * @throws BotException if it is wrong; the message shows a right one, and never contains a password
     */
    public static BrokerAddress parse(String text) {
        if (WITH_USER.matcher(text).matches()) {
            throw new BotException("user names and passwords do not belong into an address, where others can read them;"
                    + " write them into the file brokers.properties, or into the environment as MAJIC_MQTT_USER and"
                    + " MAJIC_MQTT_PASSWORD");
        }
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            throw wrong(text);
        }
        boolean secure = form.group(1).toLowerCase(Locale.ROOT).equals(SECURE_SCHEME);
        int port = form.group(3) == null ? defaultPort(secure) : Integer.parseInt(form.group(3));
        if (port < 1 || port > LARGEST_PORT) {
            throw wrong(text);
        }
        return new BrokerAddress(secure, form.group(2), port, form.group(4));
    }

    private static BotException wrong(String text) {
        return new BotException(text + ": not the address of a broker; it looks like mqtt://192.168.1.20/lab,"
                + " mqtt://broker:1883/lab or mqtts://broker:8883/school/lab");
    }

    /**
     * Returns the usual port of brokers.
     *
     * @param secure whether the connection uses TLS
     * @return {@link #PORT} or {@link #SECURE_PORT}
     */
    public static int defaultPort(boolean secure) {
        return secure ? SECURE_PORT : PORT;
    }

    /**
     * Returns the levels of the path.
     *
     * @return at least one
     */
    public List<String> levels() {
        return List.of(site.split("/"));
    }

    /**
     * Returns the same broker with another path.
     *
     * @param other one or more levels with slashes between them
     * @return the address
     */
    public BrokerAddress withSite(String other) {
        return new BrokerAddress(secure, host, port, other);
    }

    /**
     * Returns what a connection is made to.
     *
     * @return {@code host:port}
     */
    public String hostAndPort() {
        return host + ":" + port;
    }

    /**
     * Returns the address for errors, in which the port matters although it was not typed.
     *
     * @return with the port, also if it is the usual one
     */
    public String withPort() {
        return (secure ? SECURE_SCHEME : SCHEME) + "://" + hostAndPort() + "/" + site;
    }

    /** Returns the address as it is typed, without the port if it is the usual one. */
    @Override
    public String toString() {
        String scheme = secure ? SECURE_SCHEME : SCHEME;
        return scheme + "://" + (port == defaultPort(secure) ? host : hostAndPort()) + "/" + site;
    }
}

package majic.ros;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.ros.bridge.BridgeAddress;
import org.jspecify.annotations.Nullable;

/**
 * The address of a robot behind a rosbridge server:
 * {@code ros://host[:port][/namespace][?base=…&robot=…&camera=…&path=…]}, with the scheme {@code ross} for TLS.
 * Immutable.
 *
 * @param bridge where the server is
 * @param namespace of the robot, as {@code /robot1}; empty for any
 * @param base its namespace, or the topic of its odometry or of its commands; null for any
 * @param robot its name in the table of known robots; null to recognise it
 * @param camera the topic of its camera; null for the one whose name is most usual
 */
record RosAddress(
        BridgeAddress bridge,
        String namespace,
        @Nullable String base,
        @Nullable String robot,
        @Nullable String camera) {
    static final String SCHEME = "ros";
    static final String SECURE_SCHEME = "ross";

    private static final Pattern FORM =
            Pattern.compile("//(\\[[0-9a-fA-F:.]+]|[^/:?#\\s\\[\\]]+)(?::(\\d{1,5}))?((?:/[\\w/]*)?)(?:\\?(\\S*))?");
    private static final int LARGEST_PORT = 65_535;

    /**
     * Reads an address.
     *
     * @throws BotException if it is wrong; the message shows a right one
     */
    static RosAddress parse(BotAddress address) {
        boolean secure = address.scheme().equals(SECURE_SCHEME);
        Matcher form = FORM.matcher(address.rest());
        if (!secure && !address.scheme().equals(SCHEME) || !form.matches()) {
            throw wrong(address);
        }
        int port = form.group(2) == null ? BridgeAddress.PORT : Integer.parseInt(form.group(2));
        if (port < 1 || port > LARGEST_PORT) {
            throw wrong(address);
        }
        Map<String, String> options = options(address, form.group(4));
        String path = options.getOrDefault("path", "/");
        return new RosAddress(
                new BridgeAddress(form.group(1), port, path.startsWith("/") ? path : "/" + path, secure),
                form.group(3).replaceAll("/+", "/").replaceFirst("/$", ""),
                options.get("base"),
                options.get("robot"),
                options.get("camera"));
    }

    private static BotException wrong(BotAddress address) {
        return new BotException(address + ": not the address of a ROS robot; it looks like ros://192.168.1.20,"
                + " ros://192.168.1.20:9090/robot1 or ros://192.168.1.20?base=/odom");
    }

    private static Map<String, String> options(BotAddress address, @Nullable String query) {
        Map<String, String> options = new TreeMap<>();
        for (String option : query == null || query.isEmpty() ? new String[0] : query.split("&")) {
            int equals = option.indexOf('=');
            String key = equals < 0 ? option : option.substring(0, equals);
            if (equals < 0 || equals == option.length() - 1 || !key.matches("base|robot|camera|path")) {
                throw new BotException(address + ": " + option
                        + " is no option of an address; there are base=TOPIC, robot=NAME, camera=TOPIC and path=PATH, with &"
                        + " between them");
            }
            options.put(key, option.substring(equals + 1));
        }
        return options;
    }

    /** Returns the number and port of the computer that the server runs on; its name if that is not known. */
    String serverAddress() {
        try {
            return InetAddress.getByName(bridge.host()).getHostAddress() + ":" + bridge.port();
        } catch (UnknownHostException e) {
            return bridge.hostAndPort().toLowerCase(Locale.ROOT);
        }
    }

    /** Returns the address of the server, to which a namespace can be appended. */
    String server() {
        return (bridge.secure() ? SECURE_SCHEME : SCHEME) + "://" + bridge.hostAndPort();
    }
}

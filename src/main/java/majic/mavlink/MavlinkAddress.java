package majic.mavlink;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.mavlink.line.VehicleEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * The address of a vehicle: {@code mavlink://host:5760}, {@code mavlink:udp://:14550?system=3},
 * {@code mavlink:/dev/ttyUSB0?baud=57600}. Immutable.
 *
 * @param endpoint where it is reached
 * @param system its number there; 0 for the only one
 * @param radiusMm of a circle it fits in
 */
record MavlinkAddress(VehicleEndpoint endpoint, int system, double radiusMm) {
    static final String SCHEME = "mavlink";

    /** Where the simulation of ArduPilot listens (MAVLink sheet 4). */
    static final int TCP_PORT = 5760;

    /** Where ground stations listen. */
    static final int UDP_PORT = 14550;

    static final double USUAL_RADIUS_MM = 350;

    /** What other ground stations call all addresses of this computer. */
    private static final Set<String> ANY = Set.of("", "0.0.0.0", "[::]");

    private static final int USUAL_BAUD = 57600;
    private static final int LAST_SYSTEM = 254;
    private static final int LAST_PORT = 65535;
    private static final double LARGEST_RADIUS_MM = 20_000;
    private static final Pattern FORM = Pattern.compile("([^?\\s]+?)(?:(?<=[^/])/)?(?:\\?(\\S*))?");
    private static final Pattern NETWORK =
            Pattern.compile("(?:(udp|tcp):)?//(\\[[0-9a-fA-F:.]+(?:%[\\w.-]+)?]|[^/:?#@\\s\\[\\]]*)(?::(\\d{1,5}))?");

    /**
     * Reads an address.
     *
     * @throws BotException if it is wrong; the message shows right ones
     */
    static MavlinkAddress parse(BotAddress address) {
        Matcher form = FORM.matcher(address.rest());
        if (!address.scheme().equals(SCHEME) || !form.matches()) {
            throw wrong(address);
        }
        Map<String, String> options = options(address, form.group(2));
        return new MavlinkAddress(
                endpoint(address, form.group(1), options),
                options.containsKey("system") ? whole(address, options.get("system"), LAST_SYSTEM) : 0,
                radius(address, options.get("radius")));
    }

    private static VehicleEndpoint endpoint(BotAddress address, String place, Map<String, String> options) {
        Matcher network = NETWORK.matcher(place);
        if (network.matches()) {
            boolean udp = "udp".equals(network.group(1));
            String host = ANY.contains(network.group(2)) ? "" : network.group(2);
            int port =
                    network.group(3) == null ? udp ? UDP_PORT : TCP_PORT : whole(address, network.group(3), LAST_PORT);
            if (host.isEmpty() && !udp || options.containsKey("baud")) {
                throw wrong(address);
            }
            return udp ? VehicleEndpoint.udp(host, port) : VehicleEndpoint.tcp(host, port);
        }
        if (place.contains("//")) {
            throw wrong(address);
        }
        String baud = options.getOrDefault("baud", String.valueOf(USUAL_BAUD));
        return VehicleEndpoint.serial(place, whole(address, baud, 4_000_000));
    }

    private static int whole(BotAddress address, String digits, int most) {
        if (!digits.matches("\\d{1,7}") || Integer.parseInt(digits) > most || Integer.parseInt(digits) == 0) {
            throw new BotException(address + ": " + digits + " is no number from 1 to " + most);
        }
        return Integer.parseInt(digits);
    }

    private static double radius(BotAddress address, @Nullable String mm) {
        return mm == null ? USUAL_RADIUS_MM : whole(address, mm, (int) LARGEST_RADIUS_MM);
    }

    private static Map<String, String> options(BotAddress address, @Nullable String query) {
        Map<String, String> options = new HashMap<>();
        for (String option : query == null || query.isEmpty() ? new String[0] : query.split("&")) {
            int equals = option.indexOf('=');
            String key = equals < 0 ? option : option.substring(0, equals);
            if (equals < 0 || equals == option.length() - 1 || !key.matches("system|baud|radius")) {
                throw new BotException(address + ": " + option
                        + " is no option of an address; there are system=NUMBER, baud=NUMBER and radius=MM, with & between"
                        + " them");
            }
            options.put(key, option.substring(equals + 1));
        }
        return options;
    }

    private static BotException wrong(BotAddress address) {
        return new BotException(address + ": not the address of a MAVLink vehicle; it looks like mavlink:udp://:14550,"
                + " mavlink://192.168.1.20:5760 or mavlink:/dev/ttyUSB0?baud=57600, with ?system=3 for one of several");
    }
}

package majicsim.mavlink;

/**
 * What distinguishes one simulated vehicle. Immutable.
 *
 * @param kind rover, boat or copter
 * @param isReady whether it can be armed at once; otherwise it takes 44 s from its start, as a real one
 * @param version of MAVLink that it speaks: 2, or 1, which ignores frames of version 2
 * @param udpPort of a ground station on this computer, to which it also sends from its start; 0 for none
 */
public record VehicleOptions(VehicleKind kind, boolean isReady, int version, int udpPort) {
    static final String KNOWN = "rover, boat or copter, then +ready +v1 +udp=14550";

    private static final int GROUND_STATION_PORT = 14550;

    /**
     * Checks them.
     *
     * @throws IllegalArgumentException if version or port do not exist; the message names them
     */
    public VehicleOptions {
        if (version != 1 && version != 2) {
            throw new IllegalArgumentException("MAVLink has versions 1 and 2, not " + version);
        }
        if (udpPort < 0 || udpPort > 65_535) {
            throw new IllegalArgumentException("udp must be a port from 1 to 65535, not " + udpPort);
        }
    }

    /**
     * A vehicle as it comes: MAVLink 2, over TCP alone, and not ready at once.
     *
     * @param kind which
     * @return the options
     */
    public static VehicleOptions of(VehicleKind kind) {
        return new VehicleOptions(kind, false, 2, 0);
    }

    /** Parses a kind, then the differences of this vehicle behind plus signs, in any case. */
    static VehicleOptions parse(String model) {
        String[] words = model.strip().split("\\+", -1);
        VehicleOptions options = of(kind(words[0]));
        for (int i = 1; i < words.length; i++) {
            options = options.with(words[i]);
        }
        return options;
    }

    private static VehicleKind kind(String word) {
        for (VehicleKind kind : VehicleKind.values()) {
            if (kind.word().equalsIgnoreCase(word)) {
                return kind;
            }
        }
        throw unknown(word);
    }

    private VehicleOptions with(String word) {
        if (word.equalsIgnoreCase("ready")) {
            return new VehicleOptions(kind, true, version, udpPort);
        }
        if (word.equalsIgnoreCase("v1")) {
            return new VehicleOptions(kind, isReady, 1, udpPort);
        }
        if (word.equalsIgnoreCase("udp")) {
            return new VehicleOptions(kind, isReady, version, GROUND_STATION_PORT);
        }
        if (word.matches("(?i)udp=\\d{1,5}")) {
            return new VehicleOptions(kind, isReady, version, Integer.parseInt(word.substring(4)));
        }
        throw unknown(word);
    }

    private static IllegalArgumentException unknown(String word) {
        return new IllegalArgumentException("there is no '" + word + "' for a MAVLink vehicle; known are " + KNOWN);
    }
}

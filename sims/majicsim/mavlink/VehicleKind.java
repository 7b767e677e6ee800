package majicsim.mavlink;

import java.util.Locale;

/** The kinds of vehicles, with their numbers in HEARTBEAT (sheet 3). */
public enum VehicleKind {
    /** A ground vehicle that steers like a tank. */
    ROVER(10),
    /** A boat: as a rover, but it keeps its place by LOITER where a rover stops its motors. */
    BOAT(11),
    /** A quadcopter. */
    COPTER(2);

    private final int type;

    VehicleKind(int type) {
        this.type = type;
    }

    int type() {
        return type;
    }

    /** The firmware, as it calls itself at the start. */
    String firmware() {
        return this == COPTER ? "ArduCopter" : "ArduRover";
    }

    /**
     * The word by which a user chooses it.
     *
     * @return lower-case letters
     */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}

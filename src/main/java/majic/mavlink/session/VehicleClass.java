package majic.mavlink.session;

import java.util.Locale;
import majic.mavlink.message.VehicleHeartbeat;

/** The kinds of vehicles, as far as MAJIC treats them differently (MAVLink sheet 3). */
public enum VehicleClass {
    /** Drives. */
    ROVER("rover"),
    /** Swims. */
    BOAT("boat"),
    /** Flies, and stands in the air. */
    COPTER("copter"),
    /** Dives. */
    SUBMARINE("submarine"),
    /** Flies, and cannot stand. */
    PLANE("plane"),
    /** Anything else. */
    OTHER("vehicle of an unknown kind");

    private final String title;

    VehicleClass(String title) {
        this.title = title;
    }

    /** Returns the kind of the vehicle that has sent a heartbeat. */
    public static VehicleClass of(VehicleHeartbeat heartbeat) {
        return switch (heartbeat.type()) {
            case 10 -> ROVER;
            case 11 -> BOAT;
            case 2, 3, 4, 13, 14, 15 -> COPTER;
            case 12 -> SUBMARINE;
            case 1, 19, 20, 21, 22, 23, 24, 25 -> PLANE;
            default -> OTHER;
        };
    }

    /** Returns its word for users. */
    public String title() {
        return title;
    }

    /** Returns the same for lists, with a capital letter. */
    public String label() {
        return title.substring(0, 1).toUpperCase(Locale.ROOT) + title.substring(1);
    }

    /** Whether MAJIC moves it by motions. */
    public boolean isMoved() {
        return isOnSurface() || this == COPTER;
    }

    /** Whether it stays on the ground or on the water. */
    public boolean isOnSurface() {
        return this == ROVER || this == BOAT;
    }

    /** Whether it flies. */
    public boolean flies() {
        return this == COPTER || this == PLANE;
    }
}

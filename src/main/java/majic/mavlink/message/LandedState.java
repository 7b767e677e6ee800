package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * An EXTENDED_SYS_STATE: whether an aircraft is in the air. Immutable.
 *
 * @param number 1 on the ground, 2 in the air, 3 taking off, 4 landing; 0 unknown
 */
public record LandedState(int number) {
    private static final int ON_GROUND = 1;

    /** Reads the fields (MAVLink sheet 6). */
    public static LandedState of(Payload payload) {
        return new LandedState(payload.u8(1));
    }

    /** Whether it reports that it is on the ground. */
    public boolean isOnGround() {
        return number == ON_GROUND;
    }

    /** Whether it reports that it is off the ground. */
    public boolean isInAir() {
        return number > ON_GROUND;
    }
}

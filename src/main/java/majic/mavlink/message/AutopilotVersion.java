package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * An AUTOPILOT_VERSION. Immutable.
 *
 * @param major of the firmware
 * @param minor of the firmware
 * @param patch of the firmware
 * @param castsParameters whether it says that it sends the parameters that are whole numbers as numbers with a point
 */
public record AutopilotVersion(int major, int minor, int patch, boolean castsParameters) {
    private static final long PARAMETERS_ARE_CAST = 1 << 17;

    /** Reads the fields (MAVLink sheet 6). */
    public static AutopilotVersion of(Payload payload) {
        return new AutopilotVersion(
                payload.u8(19), payload.u8(18), payload.u8(17), (payload.bits64(0) & PARAMETERS_ARE_CAST) != 0);
    }

    @Override
    public String toString() {
        return major + "." + minor + "." + patch;
    }
}

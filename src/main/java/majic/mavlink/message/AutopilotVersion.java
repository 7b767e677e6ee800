package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * An AUTOPILOT_VERSION. Immutable.
 *
 * @param major of the firmware
 * @param minor of the firmware
 * @param patch of the firmware
 */
public record AutopilotVersion(int major, int minor, int patch) {
    /** Reads the fields (MAVLink sheet 6). */
    public static AutopilotVersion of(Payload payload) {
        return new AutopilotVersion(payload.u8(19), payload.u8(18), payload.u8(17));
    }

    @Override
    public String toString() {
        return major + "." + minor + "." + patch;
    }
}

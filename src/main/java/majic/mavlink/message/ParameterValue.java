package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A PARAM_VALUE. Immutable.
 *
 * @param name up to 16 characters
 * @param value as ArduPilot sends it: a plain number, whatever the type
 * @param type as MAV_PARAM_TYPE numbers it
 * @param count how many parameters there are; grows while the autopilot starts
 * @param index its place among them; {@link #NO_INDEX} for one that was set, or read by its name
 * @param bits the four bytes of the value, in which PX4 sends whole numbers
 */
public record ParameterValue(String name, double value, int type, int count, int index, int bits) {
    /** The longest name. */
    public static final int LONGEST_NAME = 16;

    /** The index of an answer that names no place. */
    public static final int NO_INDEX = 65_535;

    /** Reads the fields (MAVLink sheet 8). */
    public static ParameterValue of(Payload payload) {
        return new ParameterValue(
                payload.text(8, LONGEST_NAME),
                payload.f32(0),
                payload.u8(24),
                payload.u16(4),
                payload.u16(6),
                payload.i32(0));
    }
}

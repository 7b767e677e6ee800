package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A HEARTBEAT. Immutable.
 *
 * @param customMode the number of the mode, whose meaning depends on autopilot and vehicle
 * @param type the kind of vehicle, as MAV_TYPE numbers it
 * @param autopilot as MAV_AUTOPILOT numbers it
 * @param armed whether the motors may turn
 * @param status as MAV_STATE numbers it
 */
public record VehicleHeartbeat(long customMode, int type, int autopilot, boolean armed, int status) {
    private static final int ARMED = 128;
    private static final int CRITICAL = 5;
    private static final int NONE = 8;

    /** Reads the fields (MAVLink sheet 3). */
    public static VehicleHeartbeat of(Payload payload) {
        return new VehicleHeartbeat(
                payload.u32(0), payload.u8(4), payload.u8(5), (payload.u8(6) & ARMED) != 0, payload.u8(7));
    }

    /** Whether an autopilot sent it, and no camera or ground station. */
    public boolean isOfAutopilot() {
        return autopilot != NONE;
    }

    /** Whether a failsafe is in force. */
    public boolean isFailsafe() {
        return status >= CRITICAL;
    }
}

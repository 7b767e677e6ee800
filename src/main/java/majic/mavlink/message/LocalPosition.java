package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A LOCAL_POSITION_NED: position and velocity in the frame of the autopilot's filter. Immutable.
 *
 * @param bootMs time since the autopilot has started, ms
 * @param northM to the north of the origin, m
 * @param eastM to the east of it, m
 * @param downM below it, m
 * @param northMPerSec velocity to the north, m/s
 * @param eastMPerSec velocity to the east, m/s
 * @param downMPerSec velocity downward, m/s
 */
public record LocalPosition(
        long bootMs,
        double northM,
        double eastM,
        double downM,
        double northMPerSec,
        double eastMPerSec,
        double downMPerSec) {
    /** Reads the fields (MAVLink sheet 6). */
    public static LocalPosition of(Payload payload) {
        return new LocalPosition(
                payload.u32(0),
                payload.f32(4),
                payload.f32(8),
                payload.f32(12),
                payload.f32(16),
                payload.f32(20),
                payload.f32(24));
    }

    /** Whether the position is a number. */
    public boolean isUsable() {
        return Double.isFinite(northM + eastM + northMPerSec + eastMPerSec);
    }

    /** Whether it is exactly at the origin and at rest, as before the filter has a position (MAVLink sheet 6). */
    public boolean isZero() {
        return northM == 0 && eastM == 0 && northMPerSec == 0 && eastMPerSec == 0;
    }
}

package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * An ATTITUDE. Immutable.
 *
 * @param bootMs time since the autopilot has started, ms
 * @param rollDeg right side down positive
 * @param pitchDeg nose up positive
 * @param yawDeg clockwise from north
 * @param yawDegPerSec clockwise positive
 */
public record AttitudeReport(long bootMs, double rollDeg, double pitchDeg, double yawDeg, double yawDegPerSec) {
    /** Reads the fields (MAVLink sheet 6). */
    public static AttitudeReport of(Payload payload) {
        return new AttitudeReport(
                payload.u32(0),
                Math.toDegrees(payload.f32(4)),
                Math.toDegrees(payload.f32(8)),
                Math.toDegrees(payload.f32(12)),
                Math.toDegrees(payload.f32(24)));
    }

    /** Whether all angles are numbers. */
    public boolean isUsable() {
        return Double.isFinite(rollDeg)
                && Double.isFinite(pitchDeg)
                && Double.isFinite(yawDeg)
                && Double.isFinite(yawDegPerSec);
    }
}

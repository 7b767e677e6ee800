package majic.hemisson.motion;

import majic.bot.BotState;
import majic.bot.Pose;
import majic.hemisson.line.MotorValues;

/**
 * Where the robot should be by the motor values that were sent: dead reckoning without any measurement. Immutable.
 *
 * @param from where the present values began
 * @param sinceNanos when they began
 * @param wheels the present motor values
 * @param table what they mean
 */
public record PoseEstimate(Pose from, long sinceNanos, MotorValues wheels, SpeedTable table) {
    public static PoseEstimate standing(Pose pose, long nowNanos, SpeedTable table) {
        return new PoseEstimate(pose, nowNanos, MotorValues.STILL, table);
    }

    Pose at(long nanos) {
        double seconds = Math.max(0, nanos - sinceNanos) / 1e9;
        return from.after(table.speedMmPerSec(wheels) * seconds, table.turnDegPerSec(wheels) * seconds);
    }

    /** The estimate with other motor values from a moment on. */
    public PoseEstimate then(MotorValues next, long nanos) {
        return new PoseEstimate(at(nanos), Math.max(nanos, sinceNanos), next, table);
    }

    /** The state to publish. */
    public BotState state(long nowNanos, boolean moving) {
        return new BotState(at(nowNanos), table.speedMmPerSec(wheels), table.turnDegPerSec(wheels), moving, nowNanos);
    }
}

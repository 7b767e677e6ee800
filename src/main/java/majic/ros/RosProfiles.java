package majic.ros;

import majic.bot.BotProfile;
import majic.bot.Range;
import majic.ros.graph.KnownRobot;
import majic.velocity.BaseDynamics;

/** Converts an entry of the table of robots for the driver and the motions. */
final class RosProfiles {
    private static final double CRUISE_SHARE = 0.6;
    private static final double FASTEST_CRUISE_MM_PER_SEC = 400;
    private static final double FASTEST_CRUISE_DEG_PER_SEC = 45;

    /**
     * An obstacle counts as near if it is reached within a second at the cruising speed, and never nearer than this.
     */
    private static final double LEAST_NEAR_MM = 200;

    private RosProfiles() {}

    /** Returns size and speeds; the cruising speed is a careful one. */
    static BotProfile profile(KnownRobot robot, boolean estimates) {
        double cruise = Math.min(CRUISE_SHARE * robot.speedMmPerSec(), FASTEST_CRUISE_MM_PER_SEC);
        double cruiseTurn = Math.min(CRUISE_SHARE * robot.turnDegPerSec(), FASTEST_CRUISE_DEG_PER_SEC);
        return new BotProfile(
                robot.radiusMm(),
                new Range(-robot.speedMmPerSec(), robot.speedMmPerSec()),
                new Range(-robot.turnDegPerSec(), robot.turnDegPerSec()),
                robot.slowestMmPerSec(),
                robot.slowestDegPerSec(),
                cruise,
                cruiseTurn,
                Math.max(LEAST_NEAR_MM, cruise),
                estimates);
    }

    /** Returns the limits that the control of the base uses. */
    static BaseDynamics dynamics(KnownRobot robot) {
        return new BaseDynamics(
                robot.slowestMmPerSec(),
                robot.slowestDegPerSec(),
                robot.speedMmPerSec(),
                robot.turnDegPerSec(),
                robot.accelerationMmPerSec2(),
                robot.accelerationDegPerSec2(),
                robot.timeoutS());
    }
}

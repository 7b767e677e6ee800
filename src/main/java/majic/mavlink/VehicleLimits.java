package majic.mavlink;

import majic.bot.BotProfile;
import majic.bot.Range;
import majic.mavlink.session.VehicleSession;
import majic.velocity.Accuracy;
import majic.velocity.BaseDynamics;

/** The size and the speeds of a vehicle: what it reports, otherwise careful ones. */
final class VehicleLimits {
    private static final double USUAL_MM_PER_SEC = 2000;
    private static final double FASTEST_MM_PER_SEC = 3000;
    private static final double CRUISE_MM_PER_SEC = 500;
    private static final double SLOWEST_MM_PER_SEC = 100;
    private static final double FASTEST_DEG_PER_SEC = 60;
    private static final double CRUISE_DEG_PER_SEC = 25;
    private static final double SLOWEST_DEG_PER_SEC = 5;
    private static final double ACCELERATION_MM_PER_SEC2 = 500;
    private static final double ACCELERATION_DEG_PER_SEC2 = 50;
    private static final double NEAR_MM = 1000;

    /** An autopilot stops after this time without a velocity (MAVLink sheet 9). */
    private static final double TIMEOUT_S = 3;

    private VehicleLimits() {}

    /** The highest speed: of its waypoints, which bounds velocities too. */
    static double fastest(VehicleSession session) {
        double mPerSec = session.parameters()
                .known("WP_SPEED")
                .filter(speed -> speed > 0)
                .or(() -> session.parameters().known("CRUISE_SPEED"))
                .filter(speed -> speed > 0)
                .orElse(USUAL_MM_PER_SEC / 1000);
        return Math.max(SLOWEST_MM_PER_SEC, Math.min(FASTEST_MM_PER_SEC, 1000 * mPerSec));
    }

    static BotProfile profile(double radiusMm, double fastestMmPerSec, boolean leavesGround) {
        return new BotProfile(
                radiusMm,
                new Range(-fastestMmPerSec, fastestMmPerSec),
                new Range(-FASTEST_DEG_PER_SEC, FASTEST_DEG_PER_SEC),
                SLOWEST_MM_PER_SEC,
                SLOWEST_DEG_PER_SEC,
                Math.min(CRUISE_MM_PER_SEC, fastestMmPerSec),
                CRUISE_DEG_PER_SEC,
                NEAR_MM,
                false,
                leavesGround);
    }

    static BotProfile usual(double radiusMm) {
        return profile(radiusMm, USUAL_MM_PER_SEC, false);
    }

    static BaseDynamics dynamics() {
        return new BaseDynamics(
                SLOWEST_MM_PER_SEC,
                SLOWEST_DEG_PER_SEC,
                FASTEST_MM_PER_SEC,
                FASTEST_DEG_PER_SEC,
                ACCELERATION_MM_PER_SEC2,
                ACCELERATION_DEG_PER_SEC2,
                TIMEOUT_S,
                Accuracy.SATELLITES);
    }
}

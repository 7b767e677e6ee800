package majic.mavlink.motion;

import java.util.Optional;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.mavlink.message.GlobalPosition;
import majic.mavlink.message.LocalPosition;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;

/** One way to a place on the earth that a vehicle goes by its own navigation. Used by one thread. */
final class GlobalCourse {
    private static final double LOOK_S = 0.1;

    /** A position that is older ends the motion, seconds. */
    private static final double OLD_S = 1.5;

    /** Autopilots stop within their waypoint radius of 2 m. */
    private static final double ARRIVED_MM = 2500;

    private static final double RESTING_MM_PER_SEC = 150;
    private static final double PROGRESS_MM = 300;
    private static final double BLOCKED_S = 15;

    private final VehicleSession session;
    private final GuidedMode mode;
    private final TimeSource time;
    private final int latitudeE7;
    private final int longitudeE7;
    private double nearestMm = Double.POSITIVE_INFINITY;
    private long nearerNanos;

    GlobalCourse(VehicleSession session, GuidedMode mode, TimeSource time, int latitudeE7, int longitudeE7) {
        this.session = session;
        this.mode = mode;
        this.time = time;
        this.latitudeE7 = latitudeE7;
        this.longitudeE7 = longitudeE7;
    }

    /**
     * Goes there.
     *
     * @param halt stops the vehicle where the guard of the motion has ended it
     * @return where it has arrived
     */
    String run(Motion motion, Runnable halt) {
        nearerNanos = time.nanos();
        leftMm();
        boolean sent = session.commands()
                .run(
                        motion,
                        "go there",
                        MavlinkRequests.REPOSITION,
                        times -> MavlinkRequests.reposition(session.system(), latitudeE7, longitudeE7));
        while (sent && motion.pause(LOOK_S)) {
            double leftMm = leftMm();
            if (leftMm < ARRIVED_MM && isResting()) {
                return "arrived; " + Value.of(leftMm, Unit.MM) + " from the place";
            }
            failIfStuck(leftMm);
        }
        motion.send(halt);
        return "ended " + Value.of(leftMm(), Unit.MM) + " from the place";
    }

    private void failIfStuck(double leftMm) {
        String lost = Optional.ofNullable(mode.newest())
                .map(obstruction -> obstruction.what())
                .orElse(null);
        if (lost != null) {
            throw new MotionFailed(lost + ", " + Value.of(leftMm, Unit.MM) + " from the place");
        }
        if (leftMm < nearestMm - PROGRESS_MM) {
            nearestMm = leftMm;
            nearerNanos = time.nanos();
        }
        if (time.secondsSince(nearerNanos) > BLOCKED_S) {
            throw new MotionFailed("it has not come nearer for " + Value.plain(BLOCKED_S) + " s, "
                    + Value.of(leftMm, Unit.MM) + " from the place");
        }
    }

    private double leftMm() {
        return session.reports()
                .newest(GlobalPosition.class, OLD_S)
                .filter(GlobalPosition::isKnown)
                .map(here -> here.distanceMm(latitudeE7, longitudeE7))
                .orElseThrow(() -> new MotionFailed("the autopilot does not report where it is on the earth"));
    }

    private boolean isResting() {
        return session.reports()
                .newest(LocalPosition.class, OLD_S)
                .map(here -> 1000 * Math.hypot(here.northMPerSec(), here.eastMPerSec()))
                .filter(speed -> speed < RESTING_MM_PER_SEC)
                .isPresent();
    }
}

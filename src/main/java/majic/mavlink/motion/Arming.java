package majic.mavlink.motion;

import majic.bot.MotionFailed;
import majic.driver.Motion;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.session.VehicleClass;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;

/** Arms and disarms a vehicle by commands that its autopilot may refuse. Thread-safe. */
final class Arming {
    /** Of this time before a refusal the texts of the autopilot explain it, seconds. */
    private static final double REASONS_S = 60;

    /** A heartbeat shows an accepted command within this time, seconds. */
    private static final double SHOWN_S = 3;

    private final VehicleSession session;
    private final GuidedMode mode;
    private final FlightGuard flight;
    private final TimeSource time;

    Arming(VehicleSession session, GuidedMode mode, FlightGuard flight, TimeSource time) {
        this.session = session;
        this.mode = mode;
        this.flight = flight;
        this.time = time;
    }

    private boolean flies() {
        return session.vehicle() == VehicleClass.COPTER;
    }

    /**
     * Refuses to move it.
     *
     * @throws MotionFailed with the newest reasons of the autopilot, if it is not armed
     */
    void failUnlessArmed() {
        if (!isArmed()) {
            long from = time.nanos() - (long) (REASONS_S * 1e9);
            throw new MotionFailed("it is not armed; \"arm\" does that"
                    + (flies() ? "" : ", or \"set armByMotion on\" lets motions do it")
                    + session.texts().reasonsSince(from));
        }
    }

    boolean isArmed() {
        return session.newestHeartbeat().armed();
    }

    /**
     * Arms a rover, boat or copter, and waits until it is. A copter is in the mode GUIDED then, and its home position
     * is where it is.
     *
     * @throws MotionFailed with the reasons of the autopilot, if it refuses
     */
    CommandOutcome arm(Motion motion) {
        if (!session.vehicle().isMoved()) {
            throw new MotionFailed("it is a " + session.vehicle().title() + "; MAJIC does not arm it");
        }
        if (!motion.pause(0) || flies() && !entersGrounded(motion)) {
            return CommandOutcome.NOT_SENT;
        }
        boolean sent = session.commands().run(motion, "arm", MavlinkRequests.ARM, 1);
        boolean shown = sent && motion.await(this::isArmed, SHOWN_S);
        if (!shown && motion.guardReached()) {
            return CommandOutcome.UNCONFIRMED;
        }
        if (!shown) {
            throw new MotionFailed("the autopilot accepts to arm, but its heartbeats do not show it");
        }
        if (flies()) {
            flight.armed(flight.position());
        }
        return CommandOutcome.DONE;
    }

    /** A copter cannot be armed in the mode of a stop, and what is in the air is flown by another. */
    private boolean entersGrounded(Motion motion) {
        if (isArmed() && !flight.isArmedByMajic()) {
            throw new MotionFailed("it was armed by another, who flies it; land and disarm it first");
        }
        if (!flight.isOnGround()) {
            throw new MotionFailed("it does not report that it is on the ground");
        }
        flight.position();
        return mode.enter(motion);
    }

    /**
     * Disarms a vehicle, which stops its motors. Of a copter nothing is sent unless it is on the ground.
     *
     * @throws MotionFailed if the autopilot refuses it, or the vehicle may be in the air or under water
     */
    CommandOutcome disarm(Motion motion) {
        if (!session.vehicle().isMoved()) {
            throw new MotionFailed("it is a " + session.vehicle().title() + "; MAJIC does not disarm it");
        }
        if (flies() && isArmed() && !flight.isOnGround()) {
            throw new MotionFailed(
                    "it does not report that it is on the ground, so it is not disarmed; \"land\" lands it");
        }
        boolean sent = session.commands().run(motion, "disarm", MavlinkRequests.ARM, 0);
        boolean shown = sent && motion.await(() -> !isArmed(), SHOWN_S);
        if (!shown && motion.guardReached()) {
            return CommandOutcome.UNCONFIRMED;
        }
        if (!shown) {
            throw new MotionFailed("the autopilot accepts to disarm, but its heartbeats do not show it");
        }
        return CommandOutcome.DONE;
    }
}

package majic.pioneer.session;

import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Value;
import majic.driver.Motion;
import majic.pioneer.state.PioneerState;

/**
 * Moves the robot by a distance or an angle, with a new velocity at each SIP. The robot's own MOVE and HEAD are not
 * used: depending on the server they overshoot, creep or turn the short target round (ARCOS sheet 7.3). For one motion.
 */
public final class Maneuver {
    /** Longer than a moving robot may go without a SIP before the connection is given up, seconds. */
    private static final double SIP_S = 1.5;

    private static final double STOP_S = 4;

    /** A robot that has not moved for so long in spite of a velocity is taken to be blocked, seconds. */
    private static final double BLOCKED_S = 3;

    /** Assumed before the robot's SIP cycle is known, seconds. */
    private static final double USUAL_CYCLE_S = 0.1;

    private final PioneerSession session;
    private final WheelMotors motors;
    private final MotionTarget target;
    private final MotionFaults faults;
    private final int holdsBefore;
    private final SpeedController speeds;
    private double movedS;

    private Maneuver(PioneerSession session, MotionTarget target) {
        this.session = session;
        this.motors = session.motors();
        this.target = target;
        this.faults = new MotionFaults(session.equipment(), target.direction(), session.state());
        this.speeds = target.controller();
        this.holdsBefore = motors.holds();
    }

    /**
     * Switches the motors on if necessary, and runs a motion.
     *
     * @return the distance or angle covered; less than the target where the guard condition ended the motion
     * @throws MotionFailed if a fault ended it, the robot did not move, or its reports stopped
     */
    public static Value run(PioneerSession session, MotionTarget target, Motion motion) {
        if (!motion.pause(0)) {
            return target.value(session.state());
        }
        session.motors().switchOn(motion);
        return motion.guardReached() ? target.value(session.state()) : new Maneuver(session, target).run(motion);
    }

    private Value run(Motion motion) {
        double startedS = motion.seconds();
        while (!speeds.hasArrived(motion.seconds() - startedS)) {
            PioneerState now = session.state();
            double rate = speeds.next(target.covered(now), target.rate(now), motion.seconds() - startedS, cycleS(now));
            motion.send(() -> target.go(motors, rate, now));
            if (!awaitSip(now, motion)) {
                return endEarly(motion);
            }
            check(session.state(), motion.seconds() - startedS, motion);
        }
        motion.send(motors::zero);
        return target.value(session.state());
    }

    /** Waits for the next SIP; checks the guard condition also at other reports. */
    private boolean awaitSip(PioneerState last, Motion motion) {
        return motion.await(() -> session.state().sip() != last.sip(), SIP_S) && motion.pause(0);
    }

    private static double cycleS(PioneerState now) {
        return now.sipsPerSec() > 0 ? 1 / now.sipsPerSec() : USUAL_CYCLE_S;
    }

    private void check(PioneerState now, double seconds, Motion motion) {
        speeds.reported(target.covered(now), now.isMoving(), seconds);
        movedS = now.isMoving() ? seconds : movedS;
        String fault = faults.check(now, seconds);
        if (fault != null) {
            throw failed(fault, motion);
        }
        if (motors.holds() != holdsBefore) {
            throw failed("the robot fell silent", motion);
        }
        if (seconds - movedS > BLOCKED_S && !speeds.hasArrived(seconds)) {
            throw failed("commanded to move, it has not moved for " + (int) BLOCKED_S + " s", motion);
        }
        if (seconds > speeds.limitS()) {
            throw failed("not there within " + Value.plain(speeds.limitS()) + " s: it stopped before", motion);
        }
    }

    /** Stops the robot first: the distance in the message is that at which it comes to rest. */
    private MotionFailed failed(String reason, Motion motion) {
        motion.send(motors::sendStop);
        try {
            session.awaitStationary(STOP_S);
        } catch (LinkLost e) {
            // The last report is the last one of this session, so the pose stays there too.
        }
        return new MotionFailed(reason + " after " + target.value(session.state()));
    }

    private Value endEarly(Motion motion) {
        if (!motion.guardReached()) {
            throw failed("no report from the robot", motion);
        }
        motion.send(motors::sendStop);
        boolean stationary = session.awaitStationary(STOP_S);
        motion.check();
        if (!stationary) {
            throw failed("it does not come to rest", motion);
        }
        return target.value(session.state());
    }
}

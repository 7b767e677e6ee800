package majic.pioneer.session;

import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.Value;
import majic.pioneer.state.PioneerState;

/**
 * Covers a way by telling the robot a new speed at each SIP. The robot's own MOVE and HEAD are not used: they overshoot,
 * creep or take the short way round, each server in its own way (ARCOS sheet 7.3). For one motion.
 */
public final class Maneuver {
    /** More than the longest silence the session allows while the robot moves, seconds. */
    private static final double SIP_S = 1.5;

    private static final double STAND_S = 4;

    /** After so long a robot that was told to go and does not stir will not, seconds. */
    private static final double HELD_S = 3;

    /** Before the robot's own rhythm is known, seconds. */
    private static final double USUAL_CYCLE_S = 0.1;

    private final VelocitySetpoint velocity;
    private final ReportedState state;
    private final MotionTarget way;
    private final MotionFaults troubles;
    private final double limitS;
    private final int holdsBefore;
    private final SpeedController steering;
    private double movedS;

    public Maneuver(VelocitySetpoint velocity, ReportedState state, MotionTarget way, MotionFaults troubles) {
        this.velocity = velocity;
        this.state = state;
        this.way = way;
        this.troubles = troubles;
        this.limitS = way.approach().limitS(Math.abs(way.target()));
        this.steering = new SpeedController(way.approach(), way.target());
        this.holdsBefore = velocity.holds();
    }

    /**
     * Covers the way.
     *
     * @return how much was covered: all of it, or less where the guard ended it
     * @throws MotionFailed if the robot will not
     */
    public Value run(Motion motion) {
        double startedS = motion.seconds();
        while (!steering.isThere(motion.seconds() - startedS)) {
            PioneerState now = state.get();
            double rate = steering.next(way.covered(now), way.rate(now), motion.seconds() - startedS, cycleS(now));
            motion.send(() -> way.go(velocity, rate, now));
            if (!hearsNext(now, motion)) {
                return endEarly(motion);
            }
            look(state.get(), motion.seconds() - startedS);
        }
        motion.send(velocity::stand);
        return way.value(state.get());
    }

    /** Waits for the next SIP, and looks at the guard at whatever else comes. */
    private boolean hearsNext(PioneerState last, Motion motion) {
        return motion.await(() -> state.get().sip() != last.sip(), SIP_S) && motion.pause(0);
    }

    private static double cycleS(PioneerState now) {
        return now.sipsPerSec() > 0 ? 1 / now.sipsPerSec() : USUAL_CYCLE_S;
    }

    private void look(PioneerState now, double seconds) {
        steering.heard(way.covered(now), way.rate(now), now.isMoving(), seconds);
        movedS = now.isMoving() ? seconds : movedS;
        String trouble = troubles.look(now, seconds);
        if (trouble != null) {
            throw failed(trouble, now);
        }
        if (velocity.holds() != holdsBefore) {
            throw failed("the robot fell silent", now);
        }
        if (seconds - movedS > HELD_S && !steering.isThere(seconds)) {
            throw failed("told to go on, it has not moved for " + (int) HELD_S + " s", now);
        }
        if (seconds > limitS) {
            throw failed("not there within " + Value.plain(limitS) + " s: came to a stand", now);
        }
    }

    private MotionFailed failed(String reason, PioneerState now) {
        return new MotionFailed(reason + " after " + way.value(now));
    }

    private Value endEarly(Motion motion) {
        if (!motion.guardReached()) {
            throw failed("no word from the robot", state.get());
        }
        motion.send(velocity::stop);
        state.awaitStationary(STAND_S);
        motion.check();
        return way.value(state.get());
    }
}

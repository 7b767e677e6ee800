package majic.pioneer;

import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.Value;

/**
 * Covers a way by telling the robot a new speed at each SIP. The robot's own MOVE and HEAD are not used: they overshoot,
 * creep or take the short way round, each server in its own way (ARCOS sheet 7.3). For one motion.
 */
final class Maneuver {
    /** More than the longest silence the session allows while the robot moves, seconds. */
    private static final double READING_S = 1.5;

    private static final double STAND_S = 4;

    /** So many SIPs without motion mean that the robot will not come any nearer. */
    private static final int SETTLED_SIPS = 5;

    private final Session session;
    private final Way way;
    private final Troubles troubles;
    private final double limitS;
    private final int holdsBefore;
    private int standingSips;

    Maneuver(Session session, Way way, Troubles troubles) {
        this.session = session;
        this.way = way;
        this.troubles = troubles;
        this.limitS = Math.abs(way.target()) / way.approach().cruise() * 2 + 5;
        this.holdsBefore = session.wheels().holds();
    }

    /**
     * Covers the way.
     *
     * @return how much was covered: all of it, or less where the guard ended it
     * @throws MotionFailed if the robot will not
     */
    Value run(Motion motion) {
        double startedS = motion.seconds();
        boolean there = false;
        while (!there) {
            PioneerState now = session.state();
            double rate = way.approach().rate(way.target() - way.covered(now), way.rate(now));
            motion.send(() -> way.go(session.wheels(), rate, now));
            if (!motion.nextReading(READING_S)) {
                return endEarly(motion);
            }
            check(motion.seconds() - startedS);
            there = isThere(rate);
        }
        motion.send(session.wheels()::stand);
        return way.value(session.state());
    }

    private boolean isThere(double rate) {
        PioneerState now = session.state();
        standingSips = now.isMoving() ? 0 : standingSips + 1;
        double off = Math.abs(way.target() - way.covered(now));
        int enough = rate == 0 ? 1 : SETTLED_SIPS;
        return standingSips >= enough && off <= way.acceptable();
    }

    private void check(double seconds) {
        PioneerState now = session.state();
        String trouble = troubles.look(now, seconds);
        if (trouble != null) {
            throw failed(trouble, now);
        }
        if (session.wheels().holds() != holdsBefore) {
            throw failed("the robot fell silent", now);
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
            throw failed("no word from the robot", session.state());
        }
        motion.send(session.wheels()::stop);
        session.awaitStanding(STAND_S);
        motion.check();
        return way.value(session.state());
    }
}

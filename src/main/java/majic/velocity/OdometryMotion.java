package majic.velocity;

import majic.bot.MotionFailed;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.RenewalWatch;
import majic.driver.SentRates;
import majic.time.TimeSource;

/**
 * Moves a base by a distance or an angle, with a new velocity 20 times a second: approaches the target, lets the base
 * come to rest, and corrects what then remains a few times at most. For one motion; used by its thread.
 */
final class OdometryMotion {
    /** Approaches of one motion, the first and the corrections; further ones only while each helps. */
    private static final int USUAL_APPROACHES = 4;

    /** An approach that leaves more than this part of what was left before has not helped. */
    private static final double HELPFUL_PART = 0.8;

    /** A rate below this part of the highest one so far shows that the base is not gaining speed any more. */
    private static final double FALLEN_PART = 0.9;

    /** Long enough for a heavy base to come to rest, seconds. */
    private static final double SETTLE_S = 4;

    /** A base that ended its motion by itself may go on with a reflex; this is not awaited for longer, seconds. */
    private static final double FAILED_S = 1;

    /** A motion that takes longer than planned by this factor and time fails, though the base moves. */
    private static final double LATE_FACTOR = 5;

    private static final double LATE_S = 10;

    private final MovingBase base;
    private final Displacement way;
    private final Motion motion;
    private final MotionWatcher watcher;
    private final RenewalWatch renewals;
    private SentRates sent = new SentRates();
    private boolean gainsSpeed;
    private double highestRate;

    OdometryMotion(MovingBase base, ObstructionSource obstructions, Displacement way, Motion motion) {
        this.base = base;
        this.way = way;
        this.motion = motion;
        this.watcher = new MotionWatcher(base, obstructions, way.direction());
        this.renewals = new RenewalWatch(base.time());
    }

    /**
     * Runs the motion.
     *
     * @return the distance or angle covered; less than the target where the guard condition ended the motion
     * @throws MotionFailed if a contact or the odometry ended it, the base did not move, or it missed the target
     */
    Value run() {
        double most = way.limits().tolerance();
        boolean helped = false;
        for (int approach = 0; isOff(most) && (approach < USUAL_APPROACHES || helped); approach++) {
            double before = off();
            if (!approach() || !settle()) {
                return endEarly();
            }
            helped = off() <= HELPFUL_PART * before;
            most = way.acceptable();
        }
        if (isOff(way.tolerable())) {
            throw failed("the target was missed by more than " + Value.of(way.tolerable(), way.unit()));
        }
        return way.value(base.now());
    }

    private boolean isOff(double most) {
        return off() > most;
    }

    private double off() {
        return Math.abs(way.amount() - way.covered(base.now()));
    }

    /** Goes to the target; false if the guard condition ended the motion. */
    private boolean approach() {
        // The base is at rest, so that nothing that was sent before has an effect any more.
        sent = new SentRates();
        gainsSpeed = true;
        highestRate = 0;
        ApproachController controller =
                new ApproachController(way.amount(), way.covered(base.now()), way.limits(), sent);
        while (true) {
            TrackedState now = base.now();
            check(now);
            double rate = controller.next(
                    way.covered(now),
                    seconds(now.atNanos()),
                    seconds(time().nanos()),
                    base.delay().seconds());
            renew(() -> way.send(base, rate, now));
            if (controller.hasArrived() || endsBlocked(now)) {
                return true;
            }
            if (!motion.pause(VelocitySender.PERIOD_S)) {
                return false;
            }
            learn(now);
        }
    }

    /**
     * Sends the next velocity, unless the program has not run for a while: the base may have stopped by itself since
     * then, and must not move again by itself.
     */
    private void renew(Runnable velocity) {
        motion.send(() -> {
            if (renewals.late() == null) {
                renewals.renewed();
                velocity.run();
            }
        });
        failIfLate();
    }

    private void failIfLate() {
        String late = renewals.late();
        if (late != null) {
            throw failed(late);
        }
    }

    /** Learns the delay from the first readings that show the motion, at whatever time they arrive. */
    private void learn(TrackedState before) {
        TrackedState now = base.now();
        if (gainsSpeed && now.atNanos() != before.atNanos()) {
            double rate = Math.abs(way.rate(now));
            gainsSpeed = rate >= FALLEN_PART * highestRate
                    && base.delay().learn(sent, rate, seconds(now.atNanos()), VelocitySender.PERIOD_S);
            highestRate = Math.max(highestRate, rate);
        }
    }

    /**
     * Waits for the base to come to rest, and repeats the zero velocity meanwhile; false if the guard condition holds.
     */
    private boolean settle() {
        long zeroNanos = time().nanos();
        while (!base.isStationarySince(zeroNanos) && time().secondsSince(zeroNanos) < SETTLE_S) {
            renew(() -> base.sender().send(0, 0));
            sent.add(0, seconds(time().nanos()));
            if (!motion.pause(VelocitySender.PERIOD_S)) {
                return false;
            }
            check(base.now());
        }
        if (!base.isStationarySince(zeroNanos)) {
            throw failed("it does not come to rest");
        }
        return true;
    }

    private void check(TrackedState now) {
        failIfLate();
        String fault = watcher.check(now);
        if (fault != null) {
            throw failed(fault);
        }
        if (motion.seconds() > LATE_FACTOR * way.limits().seconds(way.amount()) + LATE_S) {
            throw failed("much slower than commanded");
        }
    }

    /** Whether the base is blocked so near to the target that the motion counts as done; farther away it has failed. */
    private boolean endsBlocked(TrackedState now) {
        if (!watcher.isBlocked(now, true)) {
            return false;
        }
        if (isOff(way.tolerable())) {
            throw failed("blocked: no progress for 2 s");
        }
        motion.send(() -> base.sender().send(0, 0));
        return true;
    }

    /**
     * Stops the base and lets it come to rest, so that the distance is the final one, and no velocity is under way any
     * more.
     */
    private MotionFailed failed(String reason) {
        motion.send(base.sender()::stop);
        if (base.silence() == null) {
            base.awaitStationary(FAILED_S + base.delay().seconds());
        }
        motion.check();
        return new MotionFailed(reason + " after " + way.value(base.now()));
    }

    private Value endEarly() {
        motion.send(base.sender()::stop);
        boolean rests = base.awaitStationary(SETTLE_S);
        motion.check();
        if (!rests) {
            throw failed("it does not come to rest");
        }
        return way.value(base.now());
    }

    private TimeSource time() {
        return base.time();
    }

    private static double seconds(long nanos) {
        return nanos / 1e9;
    }
}

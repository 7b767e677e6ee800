package majic.velocity;

import majic.bot.Unit;
import majic.bot.Value;

/** A distance or an angle to cover, from the state at the start. Immutable. */
sealed interface Displacement {
    /** The part covered so far, in {@link #unit}, signed. */
    double covered(TrackedState now);

    /** The rate at which it is being covered. */
    double rate(TrackedState now);

    /** Sends the velocity that covers it at a rate. */
    void send(MovingBase base, double rate, TrackedState now);

    /** All of it, signed. */
    double amount();

    /** Positive ahead, negative back, zero on the spot. */
    double direction();

    /** The limits of its approaches. */
    ApproachController.Limits limits();

    /** What remains at the end without being corrected. */
    double acceptable();

    /** What may remain at most; otherwise the motion has failed. */
    double tolerable();

    /** mm or degrees. */
    Unit unit();

    /** The part covered, with its unit. */
    default Value value(TrackedState now) {
        return Value.of(covered(now), unit());
    }

    /**
     * A straight line; deviations of the heading are corrected.
     *
     * @param start the state at the start
     * @param amount mm, ahead positive
     * @param limits in mm
     * @param accuracy of the base
     */
    record Straight(TrackedState start, double amount, ApproachController.Limits limits, Accuracy accuracy)
            implements Displacement {
        /** deg/s for each degree off the heading. */
        private static final double HEADING_GAIN = 1.5;

        /** A higher gain would let the heading swing about the right one: the loop is unstable from 1.57 on. */
        private static final double MOST_GAIN_TIMES_DELAY = 0.6;

        private static final double MOST_DEG_PER_SEC = 15;

        static Straight of(TrackedState start, double mm, double cruiseMmPerSec, BaseDynamics base) {
            double cruise = Math.min(cruiseMmPerSec, base.fastestMmPerSec());
            double creep = Math.min(base.slowestMmPerSec(), cruise);
            return new Straight(
                    start,
                    mm,
                    new ApproachController.Limits(
                            cruise,
                            creep,
                            base.accelerationMmPerSec2(),
                            base.accuracy().reachedMm()),
                    base.accuracy());
        }

        @Override
        public double covered(TrackedState now) {
            return start.pose().aheadMm(now.pose());
        }

        @Override
        public double rate(TrackedState now) {
            return now.speedMmPerSec();
        }

        @Override
        public void send(MovingBase base, double rate, TrackedState now) {
            double off = start.turnedDeg() - now.turnedDeg();
            double gain =
                    Math.min(HEADING_GAIN, MOST_GAIN_TIMES_DELAY / base.delay().seconds());
            double correction = Math.max(-MOST_DEG_PER_SEC, Math.min(MOST_DEG_PER_SEC, gain * off));
            base.sender().send(rate, rate == 0 ? 0 : correction);
        }

        @Override
        public double direction() {
            return amount;
        }

        @Override
        public double acceptable() {
            return accuracy.acceptableMm();
        }

        @Override
        public double tolerable() {
            return accuracy.tolerableMm();
        }

        @Override
        public Unit unit() {
            return Unit.MM;
        }
    }

    /**
     * A turn on the spot; full turns count.
     *
     * @param start the state at the start
     * @param amount degrees, counterclockwise positive
     * @param limits in degrees
     * @param accuracy of the base
     */
    record Turn(TrackedState start, double amount, ApproachController.Limits limits, Accuracy accuracy)
            implements Displacement {
        static Turn of(TrackedState start, double degrees, double cruiseDegPerSec, BaseDynamics base) {
            double cruise = Math.min(cruiseDegPerSec, base.fastestDegPerSec());
            double creep = Math.min(base.slowestDegPerSec(), cruise);
            return new Turn(
                    start,
                    degrees,
                    new ApproachController.Limits(
                            cruise,
                            creep,
                            base.accelerationDegPerSec2(),
                            base.accuracy().reachedDeg()),
                    base.accuracy());
        }

        @Override
        public double covered(TrackedState now) {
            return now.turnedDeg() - start.turnedDeg();
        }

        @Override
        public double rate(TrackedState now) {
            return now.turnRateDegPerSec();
        }

        @Override
        public void send(MovingBase base, double rate, TrackedState now) {
            base.sender().send(0, rate);
        }

        @Override
        public double direction() {
            return 0;
        }

        @Override
        public double acceptable() {
            return accuracy.acceptableDeg();
        }

        @Override
        public double tolerable() {
            return accuracy.tolerableDeg();
        }

        @Override
        public Unit unit() {
            return Unit.DEG;
        }
    }
}

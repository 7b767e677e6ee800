package majic.pioneer.session;

import majic.bot.Unit;
import majic.bot.Value;
import majic.pioneer.state.PioneerState;

/** A way to be covered from where the robot stands at its start: straight or turning on the spot. Immutable. */
public sealed interface MotionTarget {

    /** How long it is, in its unit, signed. */
    double target();

    /** How fast to cover it. */
    SpeedProfile approach();

    /** Which side of the robot goes first. */
    MotionFaults.Direction heading();

    /** How much of it is covered, in its unit, signed. */
    double covered(PioneerState now);

    /** How fast it is being covered. */
    double rate(PioneerState now);

    /** Tells the wheels to cover it at a rate. */
    void go(VelocitySetpoint wheels, double rate, PioneerState now);

    /** What it is measured in. */
    Unit unit();

    /** The part covered, as answers show it. */
    default Value value(PioneerState now) {
        return Value.of(covered(now), unit());
    }

    /**
     * Straight on, with the heading kept.
     *
     * @param start where it begins
     * @param target mm, ahead positive
     * @param approach in mm
     */
    record Straight(PioneerState start, double target, SpeedProfile approach) implements MotionTarget {
        /** deg/s for each degree off the heading. */
        private static final double HEADING_GAIN = 1;

        private static final double MOST_DEG_PER_SEC = 8;

        @Override
        public MotionFaults.Direction heading() {
            return MotionFaults.Direction.of(target);
        }

        @Override
        public double covered(PioneerState now) {
            double heading = Math.toRadians(start.pose().headingDeg());
            return (now.pose().xMm() - start.pose().xMm()) * Math.cos(heading)
                    + (now.pose().yMm() - start.pose().yMm()) * Math.sin(heading);
        }

        @Override
        public double rate(PioneerState now) {
            return now.speedMmPerSec();
        }

        @Override
        public void go(VelocitySetpoint wheels, double rate, PioneerState now) {
            double off = start.turnedDeg() - now.turnedDeg();
            double correction = Math.max(-MOST_DEG_PER_SEC, Math.min(MOST_DEG_PER_SEC, HEADING_GAIN * off));
            wheels.drive(rate, rate == 0 ? 0 : correction);
        }

        @Override
        public Unit unit() {
            return Unit.MM;
        }
    }

    /**
     * On the spot; full turns count.
     *
     * @param start where it begins
     * @param target degrees, counterclockwise positive
     * @param approach in degrees
     */
    record Turning(PioneerState start, double target, SpeedProfile approach) implements MotionTarget {
        @Override
        public MotionFaults.Direction heading() {
            return MotionFaults.Direction.AROUND;
        }

        @Override
        public double covered(PioneerState now) {
            return now.turnedDeg() - start.turnedDeg();
        }

        @Override
        public double rate(PioneerState now) {
            return now.turnRateDegPerSec();
        }

        @Override
        public void go(VelocitySetpoint wheels, double rate, PioneerState now) {
            wheels.drive(0, rate);
        }

        @Override
        public Unit unit() {
            return Unit.DEG;
        }
    }
}

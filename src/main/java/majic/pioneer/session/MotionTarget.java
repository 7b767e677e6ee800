package majic.pioneer.session;

import majic.bot.Unit;
import majic.bot.Value;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Ramps;

/** A distance or an angle to move by, from the robot's state at the start. Immutable. */
public sealed interface MotionTarget {

    /** A new controller of the rate at which it is covered. */
    SpeedController controller();

    /** Which end of the robot is in front. */
    MotionFaults.Direction direction();

    /** The part covered so far, in {@link #unit}, signed. */
    double covered(PioneerState now);

    /** The rate at which it is being covered. */
    double rate(PioneerState now);

    /** Sends the velocity that covers it at a rate. */
    void go(WheelMotors motors, double rate, PioneerState now);

    /** mm or degrees. */
    Unit unit();

    /** The part covered, with its unit. */
    default Value value(PioneerState now) {
        return Value.of(covered(now), unit());
    }

    /**
     * A straight line; deviations of the heading are corrected.
     *
     * @param start the state at the start
     * @param amount mm, ahead positive
     * @param cruise the highest speed, mm/s
     * @param ramps in force
     */
    record Straight(PioneerState start, double amount, double cruise, Ramps ramps) implements MotionTarget {
        /** deg/s for each degree off the heading. */
        private static final double HEADING_GAIN = 1;

        private static final double MOST_DEG_PER_SEC = 8;

        @Override
        public SpeedController controller() {
            return SpeedController.straight(amount, cruise, ramps);
        }

        @Override
        public MotionFaults.Direction direction() {
            return MotionFaults.Direction.of(amount);
        }

        @Override
        public double covered(PioneerState now) {
            return start.pose().aheadMm(now.pose());
        }

        @Override
        public double rate(PioneerState now) {
            return now.speedMmPerSec();
        }

        @Override
        public void go(WheelMotors motors, double rate, PioneerState now) {
            double off = start.turnedDeg() - now.turnedDeg();
            double correction = Math.max(-MOST_DEG_PER_SEC, Math.min(MOST_DEG_PER_SEC, HEADING_GAIN * off));
            motors.setVelocity(rate, rate == 0 ? 0 : correction);
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
     * @param cruise the highest turn rate, deg/s
     * @param ramps in force
     */
    record Turning(PioneerState start, double amount, double cruise, Ramps ramps) implements MotionTarget {
        @Override
        public SpeedController controller() {
            return SpeedController.turning(amount, cruise, ramps);
        }

        @Override
        public MotionFaults.Direction direction() {
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
        public void go(WheelMotors motors, double rate, PioneerState now) {
            motors.setVelocity(0, rate);
        }

        @Override
        public Unit unit() {
            return Unit.DEG;
        }
    }
}

package majic.pioneer.session;

import majic.bot.Unit;
import majic.bot.Value;
import majic.pioneer.state.PioneerState;

/** A distance or an angle to move by, from the robot's state at the start. Immutable. */
public sealed interface MotionTarget {

    /** The distance or angle, in {@link #unit}, signed. */
    double amount();

    /** The rate for each remaining distance. */
    SpeedProfile profile();

    /** Which end of the robot is in front. */
    MotionFaults.Direction direction();

    /** The part covered so far, in {@link #unit}, signed. */
    double covered(PioneerState now);

    /** The rate at which it is being covered. */
    double rate(PioneerState now);

    /** Sends the velocity that covers it at a rate. */
    void go(VelocitySetpoint velocity, double rate, PioneerState now);

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
     * @param profile in mm
     */
    record Straight(PioneerState start, double amount, SpeedProfile profile) implements MotionTarget {
        /** deg/s for each degree off the heading. */
        private static final double HEADING_GAIN = 1;

        private static final double MOST_DEG_PER_SEC = 8;

        @Override
        public MotionFaults.Direction direction() {
            return MotionFaults.Direction.of(amount);
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
        public void go(VelocitySetpoint velocity, double rate, PioneerState now) {
            double off = start.turnedDeg() - now.turnedDeg();
            double correction = Math.max(-MOST_DEG_PER_SEC, Math.min(MOST_DEG_PER_SEC, HEADING_GAIN * off));
            velocity.drive(rate, rate == 0 ? 0 : correction);
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
     * @param profile in degrees
     */
    record Turning(PioneerState start, double amount, SpeedProfile profile) implements MotionTarget {
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
        public void go(VelocitySetpoint velocity, double rate, PioneerState now) {
            velocity.drive(0, rate);
        }

        @Override
        public Unit unit() {
            return Unit.DEG;
        }
    }
}

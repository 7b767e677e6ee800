package majic.pioneer.session;

import majic.pioneer.state.Ramps;

/**
 * How fast to go with so much of the way left: at cruise, then braking evenly, then slower the nearer the end is, so that
 * the robot stands there. Distances and rates in any one unit, mm or degrees. Immutable.
 *
 * @param cruise the highest rate, positive
 * @param acceleration of the robot
 * @param deceleration of the robot; half of it is planned with, which leaves it room to follow
 * @param creep the lowest rate at which the robot still moves
 * @param tolerance how near is there
 * @param acceptable how near is near enough once it was tried
 */
public record SpeedProfile(
        double cruise, double acceleration, double deceleration, double creep, double tolerance, double acceptable) {
    private static final double SHARE = 0.5;

    /** Near the end the rate is at most this times what is left (1/s). */
    private static final double GAIN = 3;

    /** With rare readings this much of what is left is covered from one to the next. */
    private static final double STEP = 0.4;

    public static SpeedProfile straight(double cruiseMmPerSec, Ramps ramps) {
        return new SpeedProfile(cruiseMmPerSec, ramps.acceleration(), ramps.deceleration(), 15, 2, 8);
    }

    public static SpeedProfile turning(double cruiseDegPerSec, Ramps ramps) {
        return new SpeedProfile(cruiseDegPerSec, ramps.turnAcceleration(), ramps.turnDeceleration(), 3, 0.3, 0.9);
    }

    /**
     * The rate to go at.
     *
     * @param left of the way, positive
     * @param cycleS from one reading to the next, seconds
     * @return positive
     */
    double rate(double left, double cycleS) {
        return Math.max(Math.min(creep, cruise), Math.min(cruise, braking(left, Math.min(GAIN, STEP / cycleS))));
    }

    /** Even braking, joined to the proportional end where both have the same slope. */
    private double braking(double left, double gain) {
        double planned = SHARE * deceleration;
        double end = planned / (gain * gain);
        return left <= end ? gain * left : Math.sqrt(2 * planned * (left - end / 2));
    }

    /**
     * How long a way may take at most, seconds: generous, and far from for ever.
     *
     * @param way its length, positive
     */
    double limitS(double way) {
        return 2 * (way / cruise + cruise / acceleration + cruise / (SHARE * deceleration)) + 5;
    }
}

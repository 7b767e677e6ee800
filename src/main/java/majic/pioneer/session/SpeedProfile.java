package majic.pioneer.session;

import majic.pioneer.state.Ramps;

/**
 * The rate at which to move for a remaining distance: cruise, then constant braking, then proportional to the rest, so that
 * the robot stops at the end. Distances and rates are in one unit, mm or degrees. Immutable.
 *
 * @param cruise the highest rate, positive
 * @param acceleration of the robot
 * @param deceleration of the robot; the profile uses half of it, so that the robot can follow
 * @param creep the lowest rate at which the robot still moves
 * @param tolerance the distance from the end that counts as reached
 * @param acceptable the distance that counts as reached after the robot has passed the end once
 */
public record SpeedProfile(
        double cruise, double acceleration, double deceleration, double creep, double tolerance, double acceptable) {
    private static final double SHARE = 0.5;

    /** Near the end the rate is at most this times the rest (1/s). */
    private static final double GAIN = 3;

    /** With a long SIP cycle at most this share of the rest is covered in one cycle. */
    private static final double STEP = 0.4;

    public static SpeedProfile straight(double cruiseMmPerSec, Ramps ramps) {
        return new SpeedProfile(cruiseMmPerSec, ramps.acceleration(), ramps.deceleration(), 15, 2, 8);
    }

    public static SpeedProfile turning(double cruiseDegPerSec, Ramps ramps) {
        return new SpeedProfile(cruiseDegPerSec, ramps.turnAcceleration(), ramps.turnDeceleration(), 3, 0.3, 0.9);
    }

    /**
     * The rate for a remaining distance.
     *
     * @param left the rest, positive
     * @param cycleS from one SIP to the next, seconds
     * @return positive
     */
    double rate(double left, double cycleS) {
        return Math.max(Math.min(creep, cruise), Math.min(cruise, braking(left, Math.min(GAIN, STEP / cycleS))));
    }

    /** Constant braking, joined to the proportional part where both have the same slope. */
    private double braking(double left, double gain) {
        double planned = SHARE * deceleration;
        double end = planned / (gain * gain);
        return left <= end ? gain * left : Math.sqrt(2 * planned * (left - end / 2));
    }

    /**
     * The longest time that a motion may take, seconds; about twice the planned time.
     *
     * @param length of the motion, positive
     */
    double limitS(double length) {
        return 2 * (length / cruise + cruise / acceleration + cruise / (SHARE * deceleration)) + 5;
    }
}

package majic.pioneer;

/**
 * How fast to go with so much of the way left: at cruise, then braking evenly, then slower the nearer the end is, so that
 * the robot stands there. Distances and rates in any one unit, mm or degrees. Immutable.
 *
 * @param cruise the highest rate, positive
 * @param deceleration what to brake with; less than the robot can
 * @param creep the lowest rate at which the robot still moves
 * @param tolerance how near is there
 */
record Approach(double cruise, double deceleration, double creep, double tolerance) {
    /** From a reading to its effect: half a SIP cycle for its age, half for the ramp behind each command (seconds). */
    private static final double LATENCY_S = 0.1;

    /** Near the end the rate is this times what is left (1/s); slow enough for readings ten times a second. */
    private static final double GAIN = 3;

    /** Half of what the robot is set to leaves it room to follow. */
    private static final double SHARE = 0.5;

    static Approach straight(double cruiseMmPerSec, Ramps ramps) {
        return new Approach(cruiseMmPerSec, SHARE * ramps.deceleration(), 15, 2);
    }

    static Approach turning(double cruiseDegPerSec, Ramps ramps) {
        return new Approach(cruiseDegPerSec, SHARE * ramps.turnDeceleration(), 3, 0.55);
    }

    /**
     * The rate to tell the robot now.
     *
     * @param left of the way, negative when it lies behind
     * @param rate at which the robot moves now
     * @return with the sign of what is left; zero when it is there
     */
    double rate(double left, double rate) {
        if (Math.abs(left) <= tolerance) {
            return 0;
        }
        double ahead = Math.max(0, Math.abs(left) - Math.max(0, rate * Math.signum(left)) * LATENCY_S);
        double wanted = Math.max(Math.min(creep, cruise), Math.min(cruise, braking(ahead)));
        return Math.copySign(wanted, left);
    }

    /** Even braking, joined to the proportional end where both have the same slope. */
    private double braking(double ahead) {
        double end = deceleration / (GAIN * GAIN);
        return ahead <= end ? GAIN * ahead : Math.sqrt(2 * deceleration * (ahead - end / 2));
    }
}

package majic.driver;

/**
 * The rate at which the end of a displacement is approached: a constant rate, a constant deceleration, and at last a
 * rate in proportion to the rest, joined where both have the same slope. Distances and rates are in one unit, mm or
 * degrees, and positive. Immutable.
 *
 * @param cruise the highest rate
 * @param creep the lowest rate that the robot follows
 * @param deceleration less than the robot's, so that it can follow
 */
public record ApproachPlan(double cruise, double creep, double deceleration) {
    /** Near the end the rate is at most this times the rest (1/s). */
    public static final double GAIN = 3;

    /**
     * The rate for a rest.
     *
     * @param left above 0
     * @param gain of the proportional part, 1/s, {@link #GAIN} at most
     * @param raise 1, or more for a robot that has not moved at this rate
     * @return from the creep rate to the cruise rate; the cruise rate, where that is the lower one
     */
    public double rate(double left, double gain, double raise) {
        double end = deceleration / (gain * gain);
        double braking = left <= end ? gain * left : Math.sqrt(2 * deceleration * (left - end / 2));
        return Math.min(cruise, Math.max(creep, braking) * raise);
    }
}

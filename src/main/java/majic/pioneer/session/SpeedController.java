package majic.pioneer.session;

/**
 * Steers a robot to the end of a way: told at each reading how far it has come, it says how fast to go on. It comes to
 * the end from one side, and once at most from the other. Has no link or clock. For one motion.
 */
final class SpeedController {
    /** So many readings without motion mean that the robot will not come any nearer by itself. */
    private static final int SETTLED_READINGS = 5;

    /** How much harder a robot that does not stir is told to go, for each further reading. */
    private static final double NUDGE = 0.25;

    private final SpeedProfile approach;
    private final double target;
    private final LatencyModel foresight;
    private double rate;
    private double zeroSinceS;
    private double off;
    private int standing;
    private boolean reversed;
    private double lastWay;

    /**
     * Begins a way.
     *
     * @param approach how to cover it
     * @param target how long it is, signed
     */
    SpeedController(SpeedProfile approach, double target) {
        this.approach = approach;
        this.target = target;
        this.foresight = new LatencyModel(approach.acceleration(), approach.deceleration());
        this.off = Math.abs(target);
    }

    /**
     * Takes a reading.
     *
     * @param covered of the way, signed
     * @param nowRate how fast it is being covered
     * @param moving whether the robot moves at all
     * @param seconds since the motion began
     */
    void heard(double covered, double nowRate, boolean moving, double seconds) {
        foresight.heard(moving, seconds);
        standing = moving ? 0 : standing + 1;
        off = Math.abs(target - covered);
    }

    /**
     * The rate to tell the robot now, taken for told.
     *
     * @param covered of the way, signed, by the last reading
     * @param nowRate how fast it is being covered, by the last reading
     * @param seconds since the motion began
     * @param cycleS from one reading to the next
     * @return signed; zero when it is there
     */
    double next(double covered, double nowRate, double seconds, double cycleS) {
        LatencyModel.Moment then = foresight.ahead(covered, nowRate, seconds);
        double left = target - then.covered();
        double wanted = isNear(left) ? 0 : Math.copySign(nudged(approach.rate(Math.abs(left), cycleS)), left);
        if (wanted == 0 && rate != 0) {
            zeroSinceS = seconds;
        }
        reversed |= wanted * lastWay < 0;
        lastWay = wanted == 0 ? lastWay : wanted;
        rate = wanted;
        foresight.told(wanted, seconds);
        return wanted;
    }

    private boolean isNear(double left) {
        return Math.abs(left) <= (reversed ? approach.acceptable() : approach.tolerance());
    }

    private double nudged(double wanted) {
        int stuck = Math.max(0, standing - SETTLED_READINGS);
        return Math.min(approach.cruise(), wanted * (1 + NUDGE * stuck));
    }

    /** Whether the robot stands at the end, and will go on standing there. */
    boolean isThere(double seconds) {
        if (standing == 0 || off > approach.acceptable()) {
            return false;
        }
        return rate == 0 ? seconds - zeroSinceS >= foresight.delayS() : standing >= SETTLED_READINGS;
    }
}

package majic.pioneer.session;

/**
 * Computes the rate of a motion at each SIP from the part covered so far. The robot profilees the end from one side, and
 * once at most from the other. Has no link or clock. For one motion.
 */
final class SpeedController {
    /** After so many SIPs without motion the robot is taken to have settled. */
    private static final int SETTLED_READINGS = 5;

    /** By how much the rate for a robot that does not move is raised with each further SIP. */
    private static final double NUDGE = 0.25;

    private final SpeedProfile profile;
    private final double target;
    private final LatencyModel latency;
    private double rate;
    private double zeroSinceS;
    private double off;
    private int stationary;
    private boolean reversed;
    private double lastNonZero;

    /**
     * Begins a motion.
     *
     * @param profile gives the rate for the rest
     * @param target the distance or angle, signed
     */
    SpeedController(SpeedProfile profile, double target) {
        this.profile = profile;
        this.target = target;
        this.latency = new LatencyModel(profile.acceleration(), profile.deceleration());
        this.off = Math.abs(target);
    }

    /**
     * Takes in a SIP.
     *
     * @param covered the part covered, signed
     * @param nowRate the rate at which it is being covered
     * @param moving whether the robot moves at all
     * @param seconds since the motion began
     */
    void reported(double covered, double nowRate, boolean moving, double seconds) {
        latency.reported(moving, seconds);
        stationary = moving ? 0 : stationary + 1;
        off = Math.abs(target - covered);
    }

    /**
     * The rate to send now; the caller must send it.
     *
     * @param covered the part covered, signed, by the last SIP
     * @param nowRate the rate at which it is being covered, by the last SIP
     * @param seconds since the motion began
     * @param cycleS from one SIP to the next
     * @return signed; zero at the end
     */
    double next(double covered, double nowRate, double seconds, double cycleS) {
        LatencyModel.Moment then = latency.ahead(covered, nowRate, seconds);
        double left = target - then.covered();
        double wanted = isNear(left) ? 0 : Math.copySign(nudged(profile.rate(Math.abs(left), cycleS)), left);
        if (wanted == 0 && rate != 0) {
            zeroSinceS = seconds;
        }
        reversed |= wanted * lastNonZero < 0;
        lastNonZero = wanted == 0 ? lastNonZero : wanted;
        rate = wanted;
        latency.commanded(wanted, seconds);
        return wanted;
    }

    private boolean isNear(double left) {
        return Math.abs(left) <= (reversed ? profile.acceptable() : profile.tolerance());
    }

    private double nudged(double wanted) {
        int stuck = Math.max(0, stationary - SETTLED_READINGS);
        return Math.min(profile.cruise(), wanted * (1 + NUDGE * stuck));
    }

    /** Whether the robot has stopped at the end. */
    boolean hasArrived(double seconds) {
        if (stationary == 0 || off > profile.acceptable()) {
            return false;
        }
        return rate == 0 ? seconds - zeroSinceS >= latency.delayS() : stationary >= SETTLED_READINGS;
    }
}

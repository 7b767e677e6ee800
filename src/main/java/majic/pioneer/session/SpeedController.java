package majic.pioneer.session;

import majic.driver.ApproachPlan;
import majic.pioneer.state.Ramps;

/**
 * Computes the rate of a motion by its plan, at each SIP, from the part covered so far. The robot approaches the end
 * from one side, and once at most from the other. Distances and rates are in one unit, mm or degrees. Has no link or
 * clock. For one motion.
 */
final class SpeedController {
    /** With a long SIP cycle at most this share of the rest is covered in one cycle. */
    private static final double STEP = 0.4;

    /** After so many SIPs without motion the robot is taken to have settled. */
    private static final int SETTLED_READINGS = 5;

    /** By how much the rate for a robot that does not move is raised with each further SIP. */
    private static final double NUDGE = 0.25;

    private final double target;
    private final Profile profile;
    private final LatencyModel latency;
    private double rate;
    private double zeroSinceS;
    private double off;
    private int stationary;
    private boolean reversed;
    private double lastNonZero;

    /**
     * The limits of a motion.
     *
     * @param plan with half of the robot's deceleration, so that it can follow
     * @param acceleration of the robot
     * @param tolerance the distance from the end that counts as reached
     * @param acceptable the distance that counts as reached after the robot has passed the end once
     */
    private record Profile(ApproachPlan plan, double acceleration, double tolerance, double acceptable) {}

    private SpeedController(double target, Profile profile, double deceleration) {
        this.target = target;
        this.profile = profile;
        this.latency = new LatencyModel(profile.acceleration, deceleration);
        this.off = Math.abs(target);
    }

    /**
     * Begins a straight motion.
     *
     * @param mm ahead positive
     * @param cruiseMmPerSec the highest speed, positive
     */
    static SpeedController straight(double mm, double cruiseMmPerSec, Ramps ramps) {
        ApproachPlan plan = new ApproachPlan(cruiseMmPerSec, 15, ramps.deceleration() / 2.0);
        return new SpeedController(mm, new Profile(plan, ramps.acceleration(), 2, 8), ramps.deceleration());
    }

    /**
     * Begins a turn on the spot.
     *
     * @param degrees counterclockwise positive
     * @param cruiseDegPerSec the highest rate, positive
     */
    static SpeedController turning(double degrees, double cruiseDegPerSec, Ramps ramps) {
        ApproachPlan plan = new ApproachPlan(cruiseDegPerSec, 3, ramps.turnDeceleration() / 2.0);
        return new SpeedController(
                degrees, new Profile(plan, ramps.turnAcceleration(), 0.3, 0.9), ramps.turnDeceleration());
    }

    /** The longest time that the motion may take, seconds; about twice the planned time. */
    double limitS() {
        double cruise = profile.plan.cruise();
        double braking = profile.plan.deceleration();
        return 2 * (Math.abs(target) / cruise + cruise / profile.acceleration + cruise / braking) + 5;
    }

    /**
     * Takes in a SIP.
     *
     * @param covered the part covered, signed
     * @param moving whether the robot moves at all
     * @param seconds since the motion began
     */
    void reported(double covered, boolean moving, double seconds) {
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
        double wanted = isNear(left) ? 0 : Math.copySign(planned(Math.abs(left), cycleS), left);
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
        return Math.abs(left) <= (reversed ? profile.acceptable : profile.tolerance);
    }

    /** The rate for a remaining distance; both positive. */
    private double planned(double left, double cycleS) {
        int stuck = Math.max(0, stationary - SETTLED_READINGS);
        return profile.plan.rate(left, Math.min(ApproachPlan.GAIN, STEP / cycleS), 1 + NUDGE * stuck);
    }

    /** Whether the robot has stopped at the end. */
    boolean hasArrived(double seconds) {
        if (stationary == 0 || off > profile.acceptable) {
            return false;
        }
        return rate == 0 ? seconds - zeroSinceS >= latency.delayS() : stationary >= SETTLED_READINGS;
    }
}

package majic.velocity;

import majic.driver.ApproachPlan;
import majic.driver.SentRates;

/**
 * Computes the rate at which a distance or an angle is covered: an acceleration, then by the plan. Between the
 * readings, and for their delay, the base is taken to follow the rates sent. Distances and rates are in one unit, mm or
 * degrees. Has no link or clock. For one approach to the target, which ends where the target is reached or passed.
 */
final class ApproachController {
    /** A base may slow down faster than is planned, by this factor, so that it can follow the plan. */
    private static final double BRAKING_RESERVE = 2;

    /** A base whose odometry shows no effect of a rate for so long is sent a higher one, seconds. */
    private static final double STUCK_S = 0.4;

    /** By which part the rate for such a base is raised for each further second. */
    private static final double RAISE_PER_SEC = 4;

    /** The time between two commands for which the rate may change at most, seconds. */
    private static final double LONGEST_STEP_S = 0.1;

    private final double target;
    private final Limits limits;
    private final SentRates sent;
    private final double direction;
    private double lastS = Double.NaN;
    private double movedS = Double.NaN;
    private double movedAt;
    private boolean arrived;

    /**
     * The limits of an approach.
     *
     * @param cruise the highest rate
     * @param creep the lowest rate that the base follows
     * @param acceleration the change of the rate, 1/s
     * @param tolerance the distance from the target that counts as reached
     */
    record Limits(double cruise, double creep, double acceleration, double tolerance) {
        /** How long the way takes if everything is as planned, seconds. */
        double seconds(double way) {
            return Math.abs(way) / cruise + 2 * cruise / acceleration + 2 / ApproachPlan.GAIN;
        }

        ApproachPlan plan() {
            return new ApproachPlan(cruise, creep, acceleration);
        }
    }

    /**
     * Begins an approach of a stationary base.
     *
     * @param target where to go, signed
     * @param covered where the base is
     * @param sent the rates that were sent before; the ones of this approach are added
     */
    ApproachController(double target, double covered, Limits limits, SentRates sent) {
        this.target = target;
        this.limits = limits;
        this.sent = sent;
        this.direction = Math.signum(target - covered);
        this.movedAt = covered;
    }

    /** Whether the target is reached: the last rate was zero. */
    boolean hasArrived() {
        return arrived;
    }

    /**
     * The rate to send now; the caller must send it.
     *
     * @param covered the part covered, by the newest reading
     * @param readAtS when this reading arrived
     * @param nowS the time
     * @param delayS from a command to the reading that shows it
     * @return signed; zero at the target
     */
    double next(double covered, double readAtS, double nowS, double delayS) {
        double left = (target - covered - sent.covered(readAtS - delayS, nowS)) * direction;
        double rate = 0;
        if (arrived || left <= limits.tolerance()) {
            arrived = true;
        } else {
            rate = direction * limited(limits.plan().rate(left, ApproachPlan.GAIN, raise(covered, nowS, delayS)), nowS);
        }
        lastS = nowS;
        sent.add(rate, nowS);
        return rate;
    }

    /** By which factor the rate is raised for a base that does not move. */
    private double raise(double covered, double nowS, double delayS) {
        if (Double.isNaN(movedS) || Math.abs(covered - movedAt) >= limits.tolerance()) {
            movedS = nowS;
            movedAt = covered;
        }
        return 1 + RAISE_PER_SEC * Math.max(0, nowS - movedS - delayS - STUCK_S);
    }

    private double limited(double wanted, double nowS) {
        double last = Math.abs(sent.newest());
        double seconds = Double.isNaN(lastS) ? VelocitySender.PERIOD_S : Math.min(LONGEST_STEP_S, nowS - lastS);
        double most = last + limits.acceleration() * seconds;
        return Math.max(Math.min(wanted, most), last - BRAKING_RESERVE * limits.acceleration() * seconds);
    }
}

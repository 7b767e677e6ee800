package majic.velocity;

import java.util.function.DoubleSupplier;
import majic.driver.SentRates;

/**
 * The time from the sending of a velocity to the arrival of the odometry that shows its effect: the round trip of the
 * connection, which is measured all the time, and the part of the base, which is learned while a base gains speed and
 * kept from one motion to the next. Has no clock. Used by one motion at a time; thread-safe.
 */
final class OdometryDelay {
    /** The longest delay with which a base is controlled, seconds. */
    static final double LONGEST_S = 1.5;

    /** Assumed of the base before the first motion, seconds. */
    private static final double USUAL_S = 0.1;

    /** The part of the commanded rate within which a measured one is compared: noise below, overshoot above. */
    private static final double LEAST_PART = 0.2;

    private static final double LARGEST_PART = 0.8;

    /** The weight of a new measurement. */
    private static final double WEIGHT = 0.25;

    private final DoubleSupplier roundTripS;
    private volatile double baseS = USUAL_S;
    private volatile boolean learned;

    /**
     * The delay before the first motion.
     *
     * @param roundTripS gives the round trip of the connection at present, s
     */
    OdometryDelay(DoubleSupplier roundTripS) {
        this.roundTripS = roundTripS;
    }

    double seconds() {
        return Math.min(LONGEST_S, roundTripS.getAsDouble() + baseS);
    }

    /** The time after which a velocity without an effect counts as one that will have none. */
    double longestSeconds() {
        return learned ? Math.min(LONGEST_S, 2 * seconds() + USUAL_S) : LONGEST_S;
    }

    /**
     * Compares a measured rate with the commanded ones of a motion in which the base is still gaining speed.
     *
     * @param sent commanded since the motion began from rest
     * @param rate measured, by a reading that arrived now
     * @param nowS when it arrived
     * @param cycleS from one command to the next: half of it passes on average between two commanded rates
     * @return whether later readings may still show it
     */
    boolean learn(SentRates sent, double rate, double nowS, double cycleS) {
        double measured = Math.abs(rate);
        double highest = sent.highest();
        if (measured < LEAST_PART * highest || measured > LARGEST_PART * highest) {
            return measured <= LARGEST_PART * highest;
        }
        double found = nowS - sent.reachedAt(measured) - cycleS / 2 - roundTripS.getAsDouble();
        double bounded = Math.max(0, Math.min(LONGEST_S, found));
        learned = true;
        baseS += WEIGHT * (bounded - baseS);
        return true;
    }
}

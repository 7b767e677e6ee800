package majic.ros.motion;

/**
 * The time from the sending of a velocity to the arrival of the odometry that shows its effect. Learned while a base
 * accelerates, and kept from one motion to the next. Has no clock. Used by one motion at a time; thread-safe.
 */
final class OdometryDelay {
    /** Assumed before the first motion, seconds. */
    private static final double USUAL_S = 0.1;

    private static final double LONGEST_S = 0.6;

    /** The part of the commanded rate within which a measured one is compared: noise below, overshoot above. */
    private static final double LEAST_PART = 0.2;

    private static final double LARGEST_PART = 0.8;

    /** The weight of a new measurement. */
    private static final double WEIGHT = 0.25;

    private volatile double seconds = USUAL_S;

    double seconds() {
        return seconds;
    }

    /**
     * Compares a measured rate with the commanded ones of a motion that is still accelerating.
     *
     * @param sent commanded since the motion began from rest
     * @param rate measured, by a reading that arrived now
     * @param nowS when it arrived
     * @param cycleS from one command to the next: half of it passes on average between two commanded rates
     */
    void learn(SentRates sent, double rate, double nowS, double cycleS) {
        double measured = Math.abs(rate);
        double highest = sent.highest();
        if (measured < LEAST_PART * highest || measured > LARGEST_PART * highest) {
            return;
        }
        double found = nowS - sent.reachedAt(measured) - cycleS / 2;
        double bounded = Math.max(0, Math.min(LONGEST_S, found));
        seconds += WEIGHT * (bounded - seconds);
    }
}

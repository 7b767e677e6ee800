package majic.pioneer.session;

import majic.driver.SentRates;

/**
 * Predicts where the robot will be when a command sent now takes effect. A report is old when it arrives and a command
 * takes effect late; meanwhile the robot follows earlier commands. The delay is learned from the first report that
 * shows motion. Has no clock. For one motion.
 */
final class LatencyModel {
    private static final double USUAL_S = 0.05;
    private static final double LONGEST_S = 1;
    private static final double STEP_S = 0.01;

    private final double acceleration;
    private final double deceleration;
    private final SentRates sent = new SentRates();
    private double delayS = USUAL_S;
    private boolean learned;
    private int readings;

    /** A part covered and the rate there. */
    record Moment(double covered, double rate) {}

    LatencyModel(double acceleration, double deceleration) {
        this.acceleration = acceleration;
        this.deceleration = deceleration;
    }

    /** Records a command that is sent now. */
    void commanded(double rate, double seconds) {
        sent.add(rate, seconds);
    }

    /** Learns the delay from a report; motion began somewhere between the last two. */
    void reported(boolean moving, double seconds) {
        double sinceS = seconds - sent.firstS();
        if (learned || Double.isNaN(sinceS)) {
            return;
        }
        readings++;
        learned = moving || sinceS > LONGEST_S;
        if (moving) {
            delayS = Math.min(LONGEST_S, sinceS * (readings - 0.5) / readings);
        }
    }

    /** From the moment that a report describes to the effect of the command that answers it, seconds. */
    double delayS() {
        return delayS;
    }

    /**
     * Predicts.
     *
     * @param covered the part covered, by the report that came now
     * @param rate by the same
     * @param seconds now
     */
    Moment ahead(double covered, double rate, double seconds) {
        double place = covered;
        double speed = rate;
        for (double at = seconds - delayS; at < seconds; at += STEP_S) {
            speed = follow(speed, sent.at(at, rate));
            place += speed * STEP_S;
        }
        return new Moment(place, speed);
    }

    private double follow(double speed, double wanted) {
        double most = (Math.abs(wanted) < Math.abs(speed) ? deceleration : acceleration) * STEP_S;
        return speed + Math.max(-most, Math.min(most, wanted - speed));
    }
}

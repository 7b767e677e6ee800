package majic.pioneer.session;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;

/**
 * Where a robot will be when what it is told now takes effect. A reading is old when it comes and a command is late when
 * it arrives; meanwhile the robot does what it was told before. How long that takes is learned from the first reading
 * that shows it move. Has no clock. For one motion.
 */
final class LatencyModel {
    private static final double USUAL_S = 0.05;
    private static final double LONGEST_S = 1;
    private static final double STEP_S = 0.01;

    private final double acceleration;
    private final double deceleration;
    private final Deque<Sent> told = new ArrayDeque<>();
    private double delayS = USUAL_S;
    private boolean learned;
    private int readings;

    private record Sent(double rate, double seconds) {}

    /** A place on the way and the rate there. */
    record Moment(double covered, double rate) {}

    LatencyModel(double acceleration, double deceleration) {
        this.acceleration = acceleration;
        this.deceleration = deceleration;
    }

    /** Takes down a command. */
    void told(double rate, double seconds) {
        told.add(new Sent(rate, seconds));
        while (told.size() > 1 && told.peek().seconds < seconds - 2 * LONGEST_S) {
            told.remove();
        }
    }

    /** Takes down a reading; one in the middle of all those that may have been the first to show motion counts. */
    void heard(boolean moving, double seconds) {
        if (learned || told.isEmpty()) {
            return;
        }
        readings++;
        double sinceS = seconds - told.peek().seconds;
        learned = moving || sinceS > LONGEST_S;
        if (moving) {
            delayS = Math.min(LONGEST_S, sinceS * (readings - 0.5) / readings);
        }
    }

    /** From a reading's making to the effect of the answer, seconds. */
    double delayS() {
        return delayS;
    }

    /**
     * Looks ahead.
     *
     * @param covered of the way, by the reading that came now
     * @param rate by the same
     * @param seconds now
     */
    Moment ahead(double covered, double rate, double seconds) {
        double place = covered;
        double speed = rate;
        Iterator<Sent> orders = told.iterator();
        double wanted = rate;
        Sent next = orders.hasNext() ? orders.next() : null;
        for (double at = seconds - delayS; at < seconds; at += STEP_S) {
            while (next != null && next.seconds <= at) {
                wanted = next.rate;
                next = orders.hasNext() ? orders.next() : null;
            }
            speed = follow(speed, wanted);
            place += speed * STEP_S;
        }
        return new Moment(place, speed);
    }

    private double follow(double speed, double wanted) {
        double most = (Math.abs(wanted) < Math.abs(speed) ? deceleration : acceleration) * STEP_S;
        return speed + Math.max(-most, Math.min(most, wanted - speed));
    }
}

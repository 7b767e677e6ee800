package majic.aibo.session;

import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.UrbiConnection;

/**
 * Paces the periodic reports of the sensors to the link. Reports that the dog sends faster than the link carries them
 * queue up and arrive ever later; then the dog is ordered to send them at half the rate. It is ordered to send them
 * faster again when they have been on time for a while and the dog does not move. Thread-safe.
 */
final class PollPace {
    /** Readings that arrive this much later than the quickest are late, s. */
    private static final double LATE_S = 0.25;

    /** A queue that shortens by less than this from one window to the next counts as one, s. */
    private static final double SHRINKS_S = 0.05;

    /** Readings of one window: more than come between two sets of slow readings. */
    private static final int WINDOW = 8;

    /** How long readings must be on time before the dog sends them faster, s. */
    private static final double CALM_S = 10;

    private static final int SLOWEST = 16;

    private final PollCommands poll;
    private final UrbiConnection sensors;
    private final DogClock clock;
    private int slowness = 1;
    private double orderedMs = Double.POSITIVE_INFINITY;
    private int counted;
    private double leastLateS;
    private double lastWindowS;
    private boolean congested;
    private double calmSinceMs;

    PollPace(PollCommands poll, UrbiConnection sensors, DogClock clock) {
        this.poll = poll;
        this.sensors = sensors;
        this.clock = clock;
    }

    /** Orders the reports at their full rate. */
    void begin() {
        sensors.send(order(slowness));
    }

    /** What ends all reports. */
    synchronized String stop() {
        return poll.stop(slowness);
    }

    /**
     * A set of fast readings with this time stamp has arrived; those that were sent before the last order do not count.
     */
    synchronized void arrived(long stampMs) {
        if (stampMs < orderedMs) {
            return;
        }
        double lateS = (clock.estimateMs() - stampMs) / 1000 - clock.roundTripS() / 2;
        leastLateS = Math.min(leastLateS, lateS);
        counted++;
        if (counted == WINDOW) {
            endWindow();
        }
    }

    private void endWindow() {
        congested |= Math.min(leastLateS, lastWindowS) > LATE_S && leastLateS > lastWindowS - SHRINKS_S;
        if (leastLateS > LATE_S) {
            calmSinceMs = clock.estimateMs();
        }
        lastWindowS = leastLateS;
        restartWindow();
    }

    private void restartWindow() {
        leastLateS = Double.POSITIVE_INFINITY;
        counted = 0;
    }

    /** Orders another rate when it is due; called periodically. */
    void tick(boolean moving) {
        String order = due(moving);
        if (!order.isEmpty()) {
            sensors.send(order);
        }
    }

    private synchronized String due(boolean moving) {
        if (congested && slowness < SLOWEST) {
            return stop() + order(slowness * 2);
        }
        boolean calm = clock.estimateMs() - calmSinceMs > CALM_S * 1000;
        return calm && slowness > 1 && !moving ? stop() + order(slowness / 2) : "";
    }

    private synchronized String order(int newSlowness) {
        slowness = newSlowness;
        orderedMs = clock.estimateMs() + clock.roundTripS() * 1000;
        calmSinceMs = orderedMs;
        congested = false;
        lastWindowS = 0;
        restartWindow();
        return poll.start(slowness, sensors.version());
    }
}

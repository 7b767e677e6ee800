package majic.aibo.session;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiMessage;
import org.jspecify.annotations.Nullable;

/**
 * Orders the periodic reports of the sensors (URBI sheet 8), and paces them to the link. Reports that the dog sends
 * faster than the link carries them queue up and arrive ever later; then the dog is ordered to send them at half or a
 * quarter of the rate. It is ordered to send them faster again when they have been on time for a while and the dog does
 * not move. Thread-safe.
 */
final class SensorPolling {
    /** Readings that arrive this much later than the quickest are late, s. */
    private static final double LATE_S = 0.15;

    /** A queue that shortens by less than this from one window to the next counts as one, s. */
    private static final double SHRINKS_S = 0.05;

    /** Fast readings of one window: as many as come between two sets of slow ones. */
    private static final int WINDOW = 4;

    /** A queue that grows by more than this in a second needs a rate of less than half, s. */
    private static final double FAST_GROWTH = 0.8;

    /** How long readings must be on time before the dog sends them faster, s; twice as long after each queue. */
    private static final double FIRST_CALM_S = 10;

    private static final double LONGEST_CALM_S = 160;
    private static final int SLOWEST = 8;

    private final Tags tags;
    private final UrbiConnection sensors;
    private final DogClock clock;
    private final Map<String, Sensor> byTag = new HashMap<>();

    /** How many times their usual period the sensors are reported with. */
    private int slowness = 1;

    private double orderedMs = Double.POSITIVE_INFINITY;
    private int counted;
    private double leastLateS;
    private double lastWindowS;
    private int slower = 1;
    private double calmSinceMs;
    private double calmS = FIRST_CALM_S;

    SensorPolling(Tags tags, UrbiConnection sensors, DogClock clock) {
        this.tags = tags;
        this.sensors = sensors;
        this.clock = clock;
        for (Sensor sensor : Sensor.values()) {
            byTag.put(tags.named(sensor.tagName()), sensor);
        }
    }

    /** Returns the sensor that a message reports; null if none. */
    @Nullable
    Sensor sensor(UrbiMessage message) {
        return byTag.get(message.tag());
    }

    /** Orders the reports at their full rate. */
    void begin() {
        sensors.send(orderAt(slowness));
    }

    /** What ends all reports. Those at another rate have other tags, so they are not ended with them. */
    synchronized String stop() {
        return Arrays.stream(Sensor.Rate.values())
                .map(rate -> "stop " + pollTag(rate) + ", ")
                .collect(Collectors.joining());
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
        double growsS = leastLateS - lastWindowS;
        if (Math.min(leastLateS, lastWindowS) > LATE_S && growsS > -SHRINKS_S) {
            double windowS = WINDOW * slowness * Sensor.Rate.FAST.periodMs() / 1000.0;
            slower = Math.max(slower, growsS > FAST_GROWTH * windowS ? 4 : 2);
        }
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
        if (moving) {
            calmSinceMs = clock.estimateMs();
        }
        if (slower > 1 && slowness < SLOWEST) {
            calmS = Math.min(2 * calmS, LONGEST_CALM_S);
            return stop() + orderAt(Math.min(slowness * slower, SLOWEST));
        }
        boolean calm = clock.estimateMs() - calmSinceMs > calmS * 1000;
        return calm && slowness > 1 ? stop() + orderAt(slowness / 2) : "";
    }

    private synchronized String orderAt(int newSlowness) {
        slowness = newSlowness;
        orderedMs = clock.estimateMs() + clock.roundTripS() * 1000;
        calmSinceMs = orderedMs;
        slower = 1;
        lastWindowS = 0;
        restartWindow();
        return Arrays.stream(Sensor.Rate.values()).map(this::order).collect(Collectors.joining(" "));
    }

    /** The order for all sensors of a rate; a name that the dog does not have spoils only its own reading. */
    private String order(Sensor.Rate rate) {
        String readings = rate.sensors().stream()
                .map(sensor -> sensors.version().labelled(tags.named(sensor.tagName()), sensor.expression()))
                .collect(Collectors.joining(" & "));
        return pollTag(rate) + ": every(" + slowness * rate.periodMs() + ") { " + readings + " },";
    }

    private String pollTag(Sensor.Rate rate) {
        return tags.named("poll" + rate.ordinal() + "x" + slowness);
    }
}

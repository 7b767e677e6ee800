package majic.aibo.session;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Routes messages that answer no request: readings, battery lines, the rest. Called on the readers' threads. */
final class MessageRouter {
    /** A dog must not move after so long without a reading, and without one that is newer than this, seconds. */
    private static final double SILENCE_S = 1.5;

    private static final Logger LOG = System.getLogger(MessageRouter.class.getName());
    private static final Pattern BATTERY = Pattern.compile("Battery at (\\d{1,3}) ?%.*");

    private final TimeSource time;
    private final DogState dog;
    private final DogClock clock;
    private final BatteryWatch battery;
    private final SensorPolling polling;
    private final Runnable whenSensed;
    private final List<Consumer<UrbiMessage>> listeners = new CopyOnWriteArrayList<>();
    private volatile long lastReadingNanos;
    private volatile long measuredNanos;

    /** Calls the last argument when a set of readings is in. */
    MessageRouter(
            TimeSource time,
            DogState dog,
            DogClock clock,
            BatteryWatch battery,
            SensorPolling polling,
            Runnable whenSensed) {
        this.time = time;
        this.dog = dog;
        this.clock = clock;
        this.battery = battery;
        this.polling = polling;
        this.whenSensed = whenSensed;
        restartSilence();
    }

    /** For how long no reading has come, seconds. */
    double silenceS() {
        return time.secondsSince(lastReadingNanos);
    }

    /** Why the dog must not move, as half a sentence: there is no reading that is new enough; null if there is one. */
    @Nullable
    String silence() {
        if (silenceS() > SILENCE_S) {
            return "no message from the dog for " + SILENCE_S + " s";
        }
        double ageS = time.secondsSince(measuredNanos);
        return ageS > SILENCE_S
                ? String.format(Locale.ROOT, "the link to the dog is slow: its newest reading is %.1f s old", ageS)
                : null;
    }

    /** Counts the silence from now on. */
    void restartSilence() {
        lastReadingNanos = time.nanos();
        measuredNanos = lastReadingNanos;
    }

    /** How many sensors the dog has answered for. */
    long answered() {
        return Arrays.stream(Sensor.values()).filter(dog.senses()::isAnswered).count();
    }

    /** Passes all that is neither a reading nor an answer to a listener, until the result is run. */
    Runnable listen(Consumer<UrbiMessage> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /** Takes a message that answers no command. */
    void received(UrbiMessage message) {
        Sensor sensor = polling.sensor(message);
        if (sensor != null) {
            sensed(sensor, message);
        } else if (dog.leds().take(message)) {
            LOG.log(Level.TRACE, "LED: {0}", message);
        } else if (message.tag().equals("power") && message.body() instanceof UrbiMessage.Info info) {
            receivedPower(info.text(), message.timeMs());
        } else {
            LOG.log(Level.TRACE, "unasked: {0}", message);
            listeners.forEach(listener -> listener.accept(message));
        }
    }

    private void receivedPower(String text, long stampMs) {
        Matcher words = BATTERY.matcher(text);
        if (words.matches()) {
            sensed(Sensor.CHARGE, new UrbiValue.Num(Integer.parseInt(words.group(1)) / 100.0), stampMs);
        }
    }

    private void sensed(Sensor sensor, UrbiMessage message) {
        lastReadingNanos = time.nanos();
        clock.received(message.timeMs());
        if (message.body() instanceof UrbiMessage.Result result) {
            sensed(sensor, result.value(), message.timeMs());
        } else if (message.body() instanceof UrbiMessage.Failure failure) {
            dog.senses().refuse(sensor, "the dog says: " + failure.text());
        }
        if (sensor == Sensor.HEAD_PAN) {
            measured(message.timeMs());
            whenSensed.run();
        }
    }

    /** Takes the time of a set of fast readings; a damaged time stamp makes no older one of the newest. */
    private void measured(long stampMs) {
        long nanos = clock.nanosAt(stampMs);
        measuredNanos = Math.max(measuredNanos, nanos);
        dog.sensed(stampMs, nanos);
        polling.arrived(stampMs);
    }

    private void sensed(Sensor sensor, UrbiValue value, long stampMs) {
        dog.senses().put(sensor, value, stampMs);
        if (sensor == Sensor.CHARGE) {
            dog.senses().number(sensor).ifPresent(battery::update);
        }
    }
}

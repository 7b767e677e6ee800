package majic.aibo.body;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import majic.aibo.urbi.UrbiValue;
import majic.bot.Unit;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/** The newest reading of every sensor. Thread-safe. */
public final class SensorReadings {
    private static final double STIFF = 0.5;

    /** The scripts on the stick take more than this as pressed (URBI sheet 13). */
    private static final double PRESSED = 10;

    private final Map<Sensor, UrbiValue> readings = new ConcurrentHashMap<>();
    private final Map<Sensor, String> refusals = new ConcurrentHashMap<>();
    private volatile long switchedMs;

    /** Takes a reading that carried a time stamp of the dog's. */
    public void put(Sensor sensor, UrbiValue value, long stampMs) {
        if (sensor != Sensor.LEG_LOAD || stampMs >= switchedMs) {
            readings.put(sensor, value);
        }
    }

    public void refuse(Sensor sensor, String why) {
        refusals.put(sensor, why);
    }

    /** The motors were switched at a time of the dog's clock: it holds until a later reading differs. */
    public void assumeMotors(boolean on, long atMs) {
        switchedMs = atMs;
        readings.put(Sensor.LEG_LOAD, new UrbiValue.Num(on ? 1 : 0));
    }

    void clear() {
        switchedMs = 0;
        readings.clear();
        refusals.clear();
    }

    /** Whether the dog has answered for a sensor, with a reading or that it has none. */
    public boolean isAnswered(Sensor sensor) {
        return readings.containsKey(sensor) || refusals.containsKey(sensor);
    }

    /** A reading that is a finite number. */
    public Optional<Double> number(Sensor sensor) {
        return readings.get(sensor) instanceof UrbiValue.Num number && Double.isFinite(number.amount())
                ? Optional.of(number.amount())
                : Optional.empty();
    }

    /** A reading in the unit shown to users, scaled from the dog's unit. */
    public Value value(Sensor sensor, double scale, Unit unit) {
        return number(sensor).map(amount -> Value.of(amount * scale, unit)).orElseGet(() -> unknown(sensor));
    }

    /** Why there is no reading. */
    public Value unknown(Sensor sensor) {
        return Value.unknown(refusals.getOrDefault(sensor, "no reading yet"));
    }

    /** What the dog takes its posture for; null before the first report. */
    public @Nullable String posture() {
        return readings.get(Sensor.POSTURE) instanceof UrbiValue.Str guess ? guess.text() : null;
    }

    /** Whether the legs are stiff; empty while it is not known. */
    public Optional<Boolean> motorsOn() {
        return number(Sensor.LEG_LOAD).map(load -> load > STIFF);
    }

    /** Whether a touch sensor or button is pressed, a paw on the ground. */
    public boolean isPressed(Sensor sensor) {
        boolean button = switch (sensor) {
            case HEAD_TOUCH, BACK_FRONT, BACK_MIDDLE, BACK_REAR -> false;
            default -> true;
        };
        return number(sensor).orElse(0.0) > (button ? STIFF : PRESSED);
    }

    /** Whether something presses on the front of the dog, where it would run into things. */
    public boolean isBumped() {
        return isPressed(Sensor.CHIN) || isPressed(Sensor.HEAD_TOUCH);
    }

    public boolean isOnItsBack() {
        return number(Sensor.ACCEL_Z).orElse(-9.8) > 0;
    }

    /** Why a dog that walks must not walk on, as half a sentence; null if nothing is known. */
    public @Nullable String unfit() {
        if (isOnItsBack()) {
            return "the dog has fallen on its back";
        }
        return motorsOn().orElse(true) ? null : "the dog's motors were switched off";
    }

    /** Adds each reading by the expression that reads it, with two decimal places. */
    void addTexts(Map<String, String> texts) {
        readings.forEach((sensor, value) -> {
            if (value instanceof UrbiValue.Num number) {
                texts.put(sensor.expression(), String.valueOf(Math.round(number.amount() * 100) / 100.0));
            } else if (value instanceof UrbiValue.Str word) {
                texts.put(sensor.expression(), word.text());
            }
        });
    }

    /** Takes the readings that {@link #addTexts} has written. */
    void restore(Map<String, String> texts) {
        for (Sensor sensor : Sensor.values()) {
            String text = texts.get(sensor.expression());
            if (text != null) {
                readings.put(
                        sensor,
                        sensor == Sensor.POSTURE
                                ? new UrbiValue.Str(text)
                                : new UrbiValue.Num(Double.parseDouble(text)));
            }
        }
    }
}

package majic.hemisson.motion;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import majic.bot.Range;
import majic.environment.Settings;

/** The speed table of one robot, kept in the user's settings under its address. Thread-safe. */
public final class SpeedCalibration {
    public static final Range WHEEL_DISTANCE_MM = new Range(30, 300);
    public static final Range TRIM_PERCENT = new Range(-30, 30);
    public static final Range WHEEL_MM_PER_SEC = new Range(0.5, 500);

    private final Settings settings;
    private final String prefix;
    private final Consumer<SpeedTable> changed;
    private volatile SpeedTable table;

    /**
     * Reads the settings.
     *
     * @param changed takes each new table, also one that could not be kept; called by the thread that changes it
     */
    public SpeedCalibration(Settings settings, String address, Consumer<SpeedTable> changed) {
        this.settings = settings;
        this.changed = changed;
        this.prefix = "hemisson." + address.replaceFirst("^(tcp:)?//", "") + ".";
        this.table = new SpeedTable(
                keptSpeeds(),
                kept("wheelDistance", SpeedTable.USUAL_WHEEL_DISTANCE_MM, WHEEL_DISTANCE_MM),
                kept("trim", 0, TRIM_PERCENT));
    }

    public SpeedTable table() {
        return table;
    }

    /**
     * Replaces and keeps the table, for the motions from the next one on.
     *
     * @throws RuntimeException if it could not be kept; it is used all the same
     */
    public void learn(SpeedTable better) {
        table = better;
        try {
            keep(better);
        } finally {
            changed.accept(better);
        }
    }

    private void keep(SpeedTable better) {
        settings.put(
                prefix + "speedTable",
                better.speedsMmPerSec().stream().map(SpeedCalibration::text).collect(Collectors.joining(" ")));
        settings.put(prefix + "wheelDistance", text(better.wheelDistanceMm()));
        settings.put(prefix + "trim", text(better.trimPercent()));
    }

    private static String text(double number) {
        return String.format(Locale.ROOT, "%.2f", number);
    }

    /** A setting that is no sensible number counts as missing. */
    private double kept(String key, double usual, Range sensible) {
        return settings.get(prefix + key)
                .filter(SpeedCalibration::isNumber)
                .map(Double::parseDouble)
                .filter(sensible::contains)
                .orElse(usual);
    }

    private List<Double> keptSpeeds() {
        return settings.get(prefix + "speedTable")
                .map(text -> Arrays.asList(text.strip().split(" +")))
                .filter(numbers -> numbers.stream().allMatch(SpeedCalibration::isNumber))
                .map(numbers -> numbers.stream().map(Double::valueOf).toList())
                .filter(speeds -> speeds.stream().allMatch(WHEEL_MM_PER_SEC::contains) && SpeedTable.isRising(speeds))
                .orElse(SpeedTable.MANUAL);
    }

    private static boolean isNumber(String text) {
        return text.matches("-?\\d{1,4}(\\.\\d{1,9})?");
    }
}

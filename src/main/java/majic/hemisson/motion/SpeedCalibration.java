package majic.hemisson.motion;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import majic.bot.Range;
import majic.environment.Settings;

/**
 * The speed table of one robot, kept in the user's settings under what identifies the robot: the adapter of its serial
 * port, otherwise its address. A table that was kept under another name of the same adapter is taken over; the name is
 * marked as this adapter's then, so that the table is not used for another adapter that gets the name later.
 * Thread-safe.
 */
public final class SpeedCalibration {
    public static final Range WHEEL_DISTANCE_MM = new Range(30, 300);
    public static final Range TRIM_PERCENT = new Range(-30, 30);
    public static final Range WHEEL_MM_PER_SEC = new Range(0.5, 500);

    private static final String SPEEDS = "speedTable";
    private static final String WHEELS = "wheelDistance";
    private static final String TRIM = "trim";
    private static final String ADAPTER = "adapter";
    private static final Logger LOG = System.getLogger(SpeedCalibration.class.getName());

    private final Settings settings;
    private final Consumer<SpeedTable> changed;
    private volatile String name;
    private volatile SpeedTable table;

    /**
     * Reads the settings.
     *
     * @param changed takes each new table, also one that could not be kept; called by the thread that changes it
     */
    public SpeedCalibration(Settings settings, String address, Consumer<SpeedTable> changed) {
        this.settings = settings;
        this.changed = changed;
        this.name = address;
        this.table = kept(address);
    }

    /**
     * Uses the table of the robot that was found at the address.
     *
     * @param names of the robot, at least one; the first is the one under which its table is kept
     */
    public void belongsTo(List<String> names) {
        String best = names.get(0);
        if (best.equals(name)) {
            return;
        }
        name = best;
        Optional<String> old = names.stream().filter(known -> isOf(best, known)).findFirst();
        SpeedTable found = kept(old.orElse(best));
        if (old.isPresent() && !old.get().equals(best)) {
            takeOver(old.get(), found);
        }
        if (!found.equals(table)) {
            table = found;
            changed.accept(found);
        }
    }

    /** Whether a table is kept under a name, and not that of another adapter. */
    private boolean isOf(String best, String known) {
        return settings.get(prefix(known) + SPEEDS).isPresent()
                && settings.get(prefix(known) + ADAPTER)
                        .filter(other -> !other.equals(best))
                        .isEmpty();
    }

    private void takeOver(String old, SpeedTable found) {
        try {
            keep(found);
            settings.put(prefix(old) + ADAPTER, name);
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "the calibration of " + old + " is not kept for " + name, e);
        }
    }

    private static String prefix(String name) {
        return "hemisson." + name.replaceFirst("^(tcp:)?//", "") + ".";
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
        String prefix = prefix(name);
        settings.put(
                prefix + SPEEDS,
                better.speedsMmPerSec().stream().map(SpeedCalibration::text).collect(Collectors.joining(" ")));
        settings.put(prefix + WHEELS, text(better.wheelDistanceMm()));
        settings.put(prefix + TRIM, text(better.trimPercent()));
    }

    private static String text(double number) {
        return String.format(Locale.ROOT, "%.2f", number);
    }

    private SpeedTable kept(String known) {
        String prefix = prefix(known);
        return new SpeedTable(
                keptSpeeds(prefix),
                kept(prefix + WHEELS, SpeedTable.USUAL_WHEEL_DISTANCE_MM, WHEEL_DISTANCE_MM),
                kept(prefix + TRIM, 0, TRIM_PERCENT));
    }

    /** A setting that is no sensible number counts as missing. */
    private double kept(String key, double usual, Range sensible) {
        return settings.get(key)
                .filter(SpeedCalibration::isNumber)
                .map(Double::parseDouble)
                .filter(sensible::contains)
                .orElse(usual);
    }

    private List<Double> keptSpeeds(String prefix) {
        return settings.get(prefix + SPEEDS)
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

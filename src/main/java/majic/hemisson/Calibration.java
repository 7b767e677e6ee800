package majic.hemisson;

import java.util.Locale;
import majic.bot.Settings;

/** The speed table of one robot, kept in the user's settings under its address. Thread-safe. */
final class Calibration {
    private static final double SLOWEST_SCALE = 0.2;
    private static final double FASTEST_SCALE = 3;
    private static final double NARROWEST_MM = 30;
    private static final double WIDEST_MM = 300;

    private final Settings settings;
    private final String prefix;
    private volatile SpeedTable table;

    Calibration(Settings settings, String address) {
        this.settings = settings;
        this.prefix = "hemisson." + address.replaceFirst("^(tcp:)?//", "") + ".";
        this.table = new SpeedTable(
                kept("speedScale", SpeedTable.USUAL.scale(), SLOWEST_SCALE, FASTEST_SCALE),
                kept("wheelDistance", SpeedTable.USUAL_WHEEL_DISTANCE_MM, NARROWEST_MM, WIDEST_MM));
    }

    SpeedTable table() {
        return table;
    }

    /** Takes another distance between the wheels, mm, 30 to 300, and keeps it. */
    void wheelDistance(double mm) {
        table = new SpeedTable(table.scale(), mm);
        keep("wheelDistance", mm);
    }

    /** Takes another multiple of the manual's speeds, 0.2 to 3, and keeps it. */
    void speedScale(double scale) {
        table = new SpeedTable(scale, table.wheelDistanceMm());
        keep("speedScale", scale);
    }

    private void keep(String key, double number) {
        settings.put(prefix + key, String.format(Locale.ROOT, "%.4f", number));
    }

    /** A setting that somebody edited into nonsense counts as none. */
    private double kept(String key, double usual, double min, double max) {
        return settings.get(prefix + key)
                .filter(text -> text.matches("\\d{1,4}(\\.\\d{1,9})?"))
                .map(Double::parseDouble)
                .filter(number -> number >= min && number <= max)
                .orElse(usual);
    }
}

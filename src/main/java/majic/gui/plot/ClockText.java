package majic.gui.plot;

import java.util.Locale;
import majic.text.NumberText;

/** Formats times of plots. */
final class ClockText {
    /** Below this length of time shown, tenths of seconds matter. */
    private static final double TENTHS_BELOW_S = 8;

    private ClockText() {}

    /**
     * Formats a time.
     *
     * @param seconds since the start of the plot's source
     * @param shown length of the time shown, which determines the precision
     * @return for instance {@code 2:05}, {@code 1:02:05} or {@code 2:05.4}
     */
    static String of(double seconds, double shown) {
        long tenths = Math.round(Math.abs(seconds) * 10);
        boolean precise = shown < TENTHS_BELOW_S;
        long whole = precise ? tenths / 10 : Math.round(Math.abs(seconds));
        String minus = seconds < 0 && (whole > 0 || precise && tenths > 0) ? NumberText.of("-") : "";
        String hours = whole >= 3600 ? whole / 3600 + ":" : "";
        String format = hours.isEmpty() ? "%s%s%d:%02d%s" : "%s%s%02d:%02d%s";
        String fraction = precise ? "." + tenths % 10 : "";
        return String.format(Locale.ROOT, format, minus, hours, whole / 60 % 60, whole % 60, fraction);
    }
}

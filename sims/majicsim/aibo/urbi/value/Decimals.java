package majicsim.aibo.urbi.value;

import java.util.Locale;

/**
 * Numbers with six decimals, as C prints them with {@code %f} (URBI sheet, section 4). Fast, because streams of
 * readings consist of them.
 */
final class Decimals {
    private static final double MILLION = 1e6;

    /**
     * Above this value, or this near to the middle between two results, a product with a million is not exact enough.
     */
    private static final double GREATEST = 1e6;

    private static final double DOUBT = 1e-3;

    private Decimals() {}

    /** @param number finite */
    static String six(double number) {
        double millionths = Math.abs(number) * MILLION;
        double nearest = Math.rint(millionths);
        boolean doubtful = Math.abs(Math.abs(millionths - nearest) - 0.5) < DOUBT;
        if (Math.abs(number) > GREATEST || doubtful) {
            return String.format(Locale.ROOT, "%.6f", number);
        }
        long all = (long) nearest;
        String decimals = Long.toString(all % (long) MILLION + (long) MILLION).substring(1);
        String sign = Double.doubleToRawLongBits(number) < 0 ? "-" : "";
        return sign + all / (long) MILLION + "." + decimals;
    }
}

package majic.panel.map;

import majic.bot.Value;

/** Computes lengths for grids and scale bars. */
public final class Lengths {
    private Lengths() {}

    /**
     * Returns the nearest length of the series 1, 2, 5, 10 that is not longer.
     *
     * @param mm positive
     * @return mm
     */
    public static double round(double mm) {
        double decade = Math.pow(10, Math.floor(Math.log10(mm)));
        double lead = mm / decade;
        return decade * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
    }

    /**
     * Formats a length with the usual unit: {@code 20 mm}, {@code 50 cm}, {@code 1 m}.
     *
     * @param mm positive
     * @return with its unit
     */
    public static String text(double mm) {
        if (mm >= 1000) {
            return Value.plain(mm / 1000) + " m";
        }
        return mm >= 100 ? Value.plain(mm / 10) + " cm" : Value.plain(mm) + " mm";
    }
}

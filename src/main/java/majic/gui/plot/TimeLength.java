package majic.gui.plot;

/** The lengths of time that a plot can show. */
enum TimeLength {
    TEN_SECONDS("10 s", 10),
    MINUTE("1 min", 60),
    TEN_MINUTES("10 min", 600),
    ALL("All", Double.POSITIVE_INFINITY);

    private final String text;
    private final double seconds;

    TimeLength(String text, double seconds) {
        this.text = text;
        this.seconds = seconds;
    }

    String text() {
        return text;
    }

    double seconds() {
        return seconds;
    }
}

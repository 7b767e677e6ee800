package majic.gui.plot;

import majic.text.Texts;

/** The lengths of time that a plot can show. */
enum TimeLength {
    TEN_SECONDS("tenSeconds", 10),
    MINUTE("minute", 60),
    TEN_MINUTES("tenMinutes", 600),
    ALL("all", Double.POSITIVE_INFINITY);

    private static final Texts TEXTS = Texts.of(TimeLength.class);

    private final String key;
    private final double seconds;

    TimeLength(String key, double seconds) {
        this.key = key;
        this.seconds = seconds;
    }

    String text() {
        return TEXTS.get(key);
    }

    double seconds() {
        return seconds;
    }
}

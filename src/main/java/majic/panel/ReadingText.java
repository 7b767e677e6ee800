package majic.panel;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.Value;
import majic.text.NumberText;
import majic.text.Texts;

/** Formats readings for display: parameter names as plain words, and angles with {@code °}. Thread-safe. */
public final class ReadingText {
    private static final String WORD_STARTS = "(?<=[a-z0-9])(?=[A-Z])";
    private static final Texts TEXTS = Texts.of(ReadingText.class);

    private ReadingText() {}

    /**
     * Returns the label of a parameter: {@code headPan} as {@code head pan}. A single letter keeps its case.
     *
     * @param parameter its name
     * @return one or several words
     */
    public static String label(String parameter) {
        return Stream.of(parameter.split(WORD_STARTS))
                .map(word -> word.length() == 1 ? word : word.toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(" "));
    }

    /**
     * Returns the tool tip of a reading, which names its parameter, because commands and scripts need the name.
     *
     * @param parameter its name
     * @return one line
     */
    public static String tip(String parameter) {
        return TEXTS.get("inCommands", parameter);
    }

    /**
     * Formats a value in short form: without the word "about" of an estimate, and without the reason why a value is
     * unknown. Yes, no, on, off and clear are in the user's language; a word of the robot is shown as it is.
     *
     * @param value any value
     * @return for instance {@code 40°} or {@code 512 mm}; {@link ReadingsPanel#NONE} if it is unknown
     */
    public static String of(Value value) {
        if (value instanceof Value.Number number) {
            return degrees(NumberText.of(Value.of(number.amount(), number.unit())));
        }
        if (value instanceof Value.Flag flag) {
            return word(flag);
        }
        if (value instanceof Value.Many many) {
            return many.values().stream().map(ReadingText::of).collect(Collectors.joining(", "));
        }
        if (value instanceof Value.Clear) {
            return TEXTS.get("value.clear");
        }
        return value instanceof Value.Unknown ? ReadingsPanel.NONE : value.toString();
    }

    private static String word(Value.Flag flag) {
        return switch (flag.words()) {
            case YES_NO -> flag.yes() ? TEXTS.get("value.yes") : TEXTS.get("value.no");
            case ON_OFF -> flag.yes() ? TEXTS.get("value.on") : TEXTS.get("value.off");
        };
    }

    /**
     * Replaces the word for degrees by its sign.
     *
     * @param text a number with its unit: {@code 40 deg}, {@code 30 deg/s}
     * @return {@code 40°}, {@code 30 °/s}
     */
    public static String degrees(String text) {
        return text.replace(" deg/", " °/").replace(" deg", "°");
    }

    /**
     * Formats the age of a reading.
     *
     * @param seconds at least 0
     * @return {@code 12 s}, {@code 3 min}, {@code 2 h}; rounded down
     */
    public static String age(double seconds) {
        long whole = (long) seconds;
        if (whole < 60) {
            return whole + " s";
        }
        return whole < 3600 ? whole / 60 + " min" : whole / 3600 + " h";
    }
}

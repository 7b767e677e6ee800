package majic.log;

import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import majic.text.VisibleText;

/** Writes a line of the session log with its time. */
final class StampedLine {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS", Locale.ROOT);

    private StampedLine() {}

    /**
     * Returns a line with its end.
     *
     * @param kind what sort of line it is, in one word
     * @param text line ends and control characters in it are made visible
     */
    static String of(LocalDateTime time, String kind, String text) {
        return String.format(Locale.ROOT, "%s %-7s %s%n", TIME.format(time), kind, VisibleText.of(text));
    }
}

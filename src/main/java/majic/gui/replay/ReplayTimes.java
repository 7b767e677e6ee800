package majic.gui.replay;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Date;
import java.util.Locale;
import majic.text.Texts;

/** The form of times in a replay. */
final class ReplayTimes {
    private static final Texts TEXTS = Texts.of(ReplayTimes.class);
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

    private ReplayTimes() {}

    /** A time since the beginning of the recording: {@code 2:05.3}, {@code 1:02:05.3}. */
    static String clock(double seconds) {
        long tenths = Math.round(seconds * 10);
        long minutes = tenths / 600;
        String rest = String.format(Locale.ROOT, "%02d.%d", tenths / 10 % 60, tenths % 10);
        return minutes < 60
                ? minutes + ":" + rest
                : String.format(Locale.ROOT, "%d:%02d:%s", minutes / 60, minutes % 60, rest);
    }

    /** A day with its time. */
    static String day(Instant moment) {
        return TEXTS.get("day", Date.from(moment));
    }

    /** The time of day. */
    static String timeOfDay(Instant moment) {
        return TIME.format(moment.atZone(ZoneId.systemDefault()));
    }
}

package majic.team;

import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Where a STOP comes from that was not pressed in this program. Immutable.
 *
 * @param by name of the user and desk, such as {@code Anna at desk1}
 * @param time when STOP was pressed, by the clock of that desk; null if it is not known
 */
public record StopOrigin(String by, @Nullable Instant time) {
    private static final DateTimeFormatter TODAY = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT);
    private static final DateTimeFormatter EARLIER = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm", Locale.ROOT);

    /**
     * Returns when STOP was pressed, in the time zone of this computer.
     *
     * @return {@code 14:02} for a time of today, otherwise {@code 2026-11-22 14:02}; empty if it is not known
     */
    public String timeText() {
        if (time == null) {
            return "";
        }
        LocalDateTime local = LocalDateTime.ofInstant(time, ZoneId.systemDefault());
        return local.format(local.toLocalDate().equals(LocalDate.now(ZoneId.systemDefault())) ? TODAY : EARLIER);
    }

    /** Returns the beginning of a sentence, such as {@code STOP by Anna at desk1, pressed at 14:02}. */
    @Override
    public String toString() {
        return "STOP by " + by + (time == null ? "" : ", pressed at " + timeText() + ",");
    }
}

package majic.bot;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * The result of a motion that ended without an error. Immutable; {@code toString()} gives the text of answers.
 *
 * @param amount how far it went, mm or degrees, by odometry or as an estimate; null if it is not measured
 * @param seconds how long it took
 */
public record MotionReport(@Nullable Value amount, double seconds) {
    @Override
    public String toString() {
        String time = String.format(Locale.ROOT, "%.1f s", seconds);
        if (amount == null) {
            return time;
        }
        return amount + (amount instanceof Value.Many ? "; " : ", ") + time;
    }
}

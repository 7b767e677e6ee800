package majicsim.aibo.urbi.memory;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** What happens when several assignments act on one variable (URBI sheet, section 6). */
public enum Blend {
    /** The last one counts. */
    NORMAL,
    /** They are averaged. */
    MIX,
    /** They are added. */
    ADD,
    /** The second one has no effect. */
    DISCARD,
    /** The second one waits for the end of the first. */
    QUEUE,
    /** The second one ends the first. */
    CANCEL;

    public static @Nullable Blend named(String name) {
        for (Blend blend : values()) {
            if (blend.word().equals(name)) {
                return blend;
            }
        }
        return null;
    }

    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    double combine(double last, double sum, int writers) {
        return switch (this) {
            case MIX -> sum / writers;
            case ADD -> sum;
            case NORMAL, DISCARD, QUEUE, CANCEL -> last;
        };
    }
}

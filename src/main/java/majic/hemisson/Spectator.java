package majic.hemisson;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** What the robot's tab shows beside what every command needs, as it was heard last. Thread-safe. */
final class Spectator {
    private final MajicHemisson bot;

    Spectator(MajicHemisson bot) {
        this.bot = bot;
    }

    /**
     * The light on the eight sensors.
     *
     * @param raw 0 bright to 255 dark, in the order of the robot's answer
     * @param atNanos when it was read
     */
    record Light(List<Integer> raw, long atNanos) {
        Light {
            raw = List.copyOf(raw);
        }
    }

    /** The light read last; null before the first. */
    @Nullable
    Light light() {
        Senses.Heard heard = bot.overseer().senses().heard(Question.LIGHT);
        return heard == null ? null : new Light(heard.reply().numbers(), heard.nanos());
    }

    /** The switches as they are now; those of the time of connecting before the first reading. */
    List<Integer> switches() {
        Senses.Heard heard = bot.overseer().senses().heard(Question.SWITCHES);
        return heard == null ? bot.identity().switches() : heard.reply().numbers();
    }
}

package majic.script.record;

import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Something that was done in a session. Immutable.
 *
 * @param kind what it is
 * @param atNanos when it was done, on the clock of the team; of a wait, when it was over
 * @param text the lines that do it again
 * @param robots those that it makes do something, stops or waits for
 * @param begins those of them that had nothing to do before it; of a stop, those that may have been moving
 * @param finished others that had finished their commands by then, and when
 * @param block the block it was done by; null for a line of its own
 */
public record RecordedEvent(
        Kind kind,
        long atNanos,
        String text,
        Set<Integer> robots,
        Set<Integer> begins,
        Map<Integer, Long> finished,
        @Nullable RecordedBlock block) {
    /** Robots as a line names them: {@code 1,3}. */
    public static String names(Collection<Integer> robots) {
        return robots.stream().sorted().map(String::valueOf).collect(Collectors.joining(","));
    }

    /** What can be recorded. */
    enum Kind {
        /** A robot was connected, which takes its own time when it is done again. */
        ADD,
        /** A command. */
        COMMAND,
        /** Robots were waited for. */
        WAIT,
        /** Robots were stopped, or their act was ended. */
        STOP,
        /** A whole block, from its beginning on. */
        BLOCK
    }
}

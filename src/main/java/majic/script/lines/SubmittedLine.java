package majic.script.lines;

import java.util.function.Consumer;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.Trait;
import org.jspecify.annotations.Nullable;

/**
 * A prepared line that was submitted to run. Immutable.
 *
 * @param line the line
 * @param stops how often the robots it commands had been stopped by then
 * @param refused receives the reason if the files it names do not let it be done
 * @param failed receives the reason if the session or a robot refuses it when its turn comes
 * @param sent whether it is a stop that was sent already, of which only the end is waited for
 * @param checked runs what was checked just now; null for a line that has to be checked again, because it waited
 */
record SubmittedLine(
        PreparedLine line,
        long stops,
        Consumer<String> refused,
        Consumer<String> failed,
        boolean sent,
        @Nullable Consumer<Execution> checked) {
    /** Returns the line as it was submitted, not yet sent, to be checked when it runs. */
    static SubmittedLine of(PreparedLine line, long stops, Consumer<String> refused, Consumer<String> failed) {
        return new SubmittedLine(line, stops, refused, failed, false, null);
    }

    /** The same, once it was sent. */
    SubmittedLine asSent() {
        return new SubmittedLine(line, stops, refused, failed, true, checked);
    }

    /** The same, to be run without another check. */
    SubmittedLine asChecked(@Nullable Consumer<Execution> run) {
        return new SubmittedLine(line, stops, refused, failed, sent, run);
    }

    String title() {
        return line.title();
    }

    Scheduling scheduling() {
        return line.scheduling();
    }

    boolean has(Trait trait) {
        return line.has(trait);
    }
}

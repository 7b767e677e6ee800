package majic.script.lines;

import java.util.function.Consumer;
import majic.script.run.Scheduling;
import majic.script.run.Trait;

/**
 * A prepared line that was submitted to run. Immutable.
 *
 * @param line the line
 * @param stops how often the robots it commands had been stopped by then
 * @param refused receives the reason if the files it names do not let it be done
 * @param failed receives the reason if the session or a robot refuses it when its turn comes
 * @param sent whether it is a stop that was sent already, of which only the end is waited for
 */
record SubmittedLine(PreparedLine line, long stops, Consumer<String> refused, Consumer<String> failed, boolean sent) {
    /** The same, once it was sent. */
    SubmittedLine asSent() {
        return new SubmittedLine(line, stops, refused, failed, true);
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

package majic.gui.kit;

import java.util.Optional;
import java.util.function.Consumer;

/** Submits lines and shows messages for the parts of the window. Callable from any thread; returns at once. */
public interface CommandChannel {
    /**
     * Submits lines as if they had been typed; their results are shown among the messages.
     *
     * @param lines one or several; all up to the first refused one are accepted
     */
    void submit(String lines);

    /**
     * Submits a line of a dialog. One that is no MAJIC Script is not submitted.
     *
     * @param line a command
     * @param ended receives on the event dispatch thread why the line was refused; empty if it was accepted
     */
    void submit(String line, Consumer<Optional<String>> ended);

    /**
     * Shows a message that does not come from the session.
     *
     * @param sentence what is wrong, and what would be right
     */
    void showError(String sentence);
}

package majic.gui.kit;

/** Submits lines and shows messages for the parts of the window. Callable from any thread; returns at once. */
public interface CommandChannel {
    /**
     * Submits lines as if they had been typed; their results are shown among the messages.
     *
     * @param lines one or several; all up to the first refused one are accepted
     */
    void submit(String lines);

    /**
     * Shows a message that does not come from the session.
     *
     * @param sentence what is wrong, and what would be right
     */
    void showError(String sentence);
}

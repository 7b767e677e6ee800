package majic.gui.kit;

/** How a part of the window gets heard. Callable from any thread; returns at once. */
public interface Voice {
    /**
     * Gives lines as if they had been typed; what becomes of them is shown among the messages.
     *
     * @param lines one or several, all up to the first that is refused are taken
     */
    void say(String lines);

    /**
     * Tells the person something that the session does not know.
     *
     * @param sentence what is wrong, and what would be right
     */
    void complain(String sentence);
}

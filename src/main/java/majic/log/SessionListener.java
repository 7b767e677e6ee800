package majic.log;

/** Hears what is said in a session. */
@FunctionalInterface
public interface SessionListener {
    /**
     * Something was said. Called on a thread that this listener alone has, one line at a time and in the order things
     * happened; it may take its time.
     *
     * @param line what was said
     */
    void line(Line line);
}

package majic.log;

/** Receives the lines of a session. */
@FunctionalInterface
public interface SessionListener {
    /**
     * Receives a line. Called on a thread of this listener alone, one line at a time and in the order of events; may
     * block.
     *
     * @param line the line
     */
    void line(Line line);
}

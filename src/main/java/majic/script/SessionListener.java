package majic.script;

/** Hears what is said in a session. */
@FunctionalInterface
public interface SessionListener {
    /**
     * Something was said. Called on any thread, one line at a time and in the order things happened; be quick, since
     * robots wait meanwhile.
     *
     * @param line what was said
     */
    void line(Line line);
}

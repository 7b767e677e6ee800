package majic.log;

/** Receives the lines of a session, and the additions of robots that a password would allow. */
@FunctionalInterface
public interface SessionListener {
    /**
     * Receives a line. Called on a thread of this listener alone, one line at a time and in the order of events; may
     * block.
     *
     * @param line the line
     */
    void line(Line line);

    /**
     * Reports that a robot could not be added because the user name or the password is missing or wrong. The line that
     * fails follows. Called like {@link #line}; does nothing unless it is overridden.
     *
     * @param address the address of the robot
     * @param again a line of MAJIC Script that adds it
     */
    default void loginRefused(String address, String again) {}
}

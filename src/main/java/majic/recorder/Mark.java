package majic.recorder;

/**
 * An event of a recorded session, to be marked on a time axis.
 *
 * @param seconds since the beginning of the recording
 * @param kind what happened
 * @param robot the number of the robot; 0 if it concerns all
 * @param text one line: the command, the answer, the reason
 */
public record Mark(double seconds, Kind kind, int robot, String text) {
    /** What happened. */
    public enum Kind {
        /** A robot was added. */
        ADDED,
        /** A robot was removed. */
        REMOVED,
        /** A robot began a command of its queue. */
        BEGUN,
        /** A command was answered. */
        ENDED,
        /** Robots were stopped by a user, one of them or all. */
        STOP,
        /** A robot did not confirm its stop. */
        UNCONFIRMED,
        /** STOP was released. */
        RELEASED,
        /** The connection to a robot was lost. */
        LOST,
        /** A lost robot was connected again. */
        REGAINED,
        /** A robot has another owner, or none. */
        OWNER
    }
}

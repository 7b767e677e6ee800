package majic.team;

import org.jspecify.annotations.Nullable;

/**
 * The result of a command, worded the same everywhere (MAJIC Script, "Answers"). Immutable.
 *
 * @param robot the robot's number; 0 when the session as a whole answers
 * @param outcome how the command ended
 * @param text the whole line, for instance {@code 1 move 500: done (498 mm, 2.1 s)}
 * @param asker the asker of the command; null if the answer concerns all
 */
public record Answer(
        int robot, Outcome outcome, String text, @Nullable Object asker) {
    /**
     * Creates an answer that concerns all.
     *
     * @param robot the robot's number; 0 when the session as a whole answers
     * @param outcome how the command ended
     * @param text the whole line
     */
    public Answer(int robot, Outcome outcome, String text) {
        this(robot, outcome, text, null);
    }

    /** How a command can end. */
    public enum Outcome {
        /** Completed normally. */
        DONE,
        /** Ended by a stop, or removed by it before it began. */
        STOPPED,
        /** Ended with an error. */
        FAILED,
        /** A stop that the robot did not confirm. */
        NOT_STOPPED,
        /** Not begun, because an earlier command failed or the robot was removed. */
        NOT_RUN
    }

    @Override
    public String toString() {
        return text;
    }
}

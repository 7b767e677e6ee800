package majic.team;

import org.jspecify.annotations.Nullable;

/**
 * What became of a command, in words that stay the same everywhere (MAJIC Script, "Answers"). Immutable.
 *
 * @param robot the robot's number; 0 when the session as a whole answers
 * @param outcome how it ended
 * @param text the whole line, for instance {@code 1 move 500: done (498 mm, 2.1 s)}
 * @param asker what the order carried as its asker; null if the answer concerns all
 */
public record Answer(
        int robot, Outcome outcome, String text, @Nullable Object asker) {
    /**
     * An answer that concerns all.
     *
     * @param robot the robot's number; 0 when the session as a whole answers
     * @param outcome how it ended
     * @param text the whole line
     */
    public Answer(int robot, Outcome outcome, String text) {
        this(robot, outcome, text, null);
    }

    /** How a command can end. */
    public enum Outcome {
        /** As it should. */
        DONE,
        /** By a stop. */
        STOPPED,
        /** With an error. */
        FAILED,
        /** It was not begun, because something before it failed or was stopped. */
        NOT_RUN
    }

    /**
     * Whether the command did what it was told.
     *
     * @return true only for {@link Outcome#DONE}
     */
    public boolean isDone() {
        return outcome == Outcome.DONE;
    }

    @Override
    public String toString() {
        return text;
    }
}

package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import majic.bot.BotControl;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * A command to one robot, from its creation until it has ended: its text, what it does and, once it was accepted by
 * {@link Member#submit} or {@link Member#runNow}, how it ended. Is submitted once. Thread-safe; wait for its end at
 * {@link Team#changes()}.
 */
public final class QueuedCommand {
    private static final Logger LOG = System.getLogger(QueuedCommand.class.getName());

    private final String text;
    private final boolean moves;
    private final Work work;
    private Runnable check = () -> {};
    private @Nullable Object asker;
    private Consumer<Answer> ending = answer -> {};
    private volatile @Nullable BotControl control;
    private volatile Answer.@Nullable Outcome outcome;
    private volatile boolean ended;

    /** What a command does when its turn comes. */
    @FunctionalInterface
    public interface Work {
        /**
         * Does the work, and blocks until it is done.
         *
         * @param robot the robot, which no longer moves once it was stopped after the command was submitted
         * @return the answers, each without the robot's number: {@code move 500: done (498 mm, 2.1 s)}
         * @throws BotException if it could not be done; the command has failed then
         */
        List<String> run(BotControl robot);
    }

    /**
     * Creates a command that was not submitted yet, without an asker.
     *
     * @param text the command without the robot, as answers repeat it: {@code move 500}
     * @param moves whether it may move the robot, and so needs the robot to be free and no STOP latched
     * @param work what it does
     */
    public QueuedCommand(String text, boolean moves, Work work) {
        this.text = text;
        this.moves = moves;
        this.work = work;
    }

    /**
     * Sets the asker, before the command is submitted.
     *
     * @param by returned with the answers, so that they can be routed to the source of the command; null for no
     *     particular source
     * @return this command
     * @throws IllegalStateException if it was accepted before
     */
    public synchronized QueuedCommand askedBy(@Nullable Object by) {
        requireNew();
        asker = by;
        return this;
    }

    /**
     * Adds a check that is made when the turn of the command comes, before those that it has; before the command is
     * submitted.
     *
     * @param further throws a {@link BotException} if the command must not begin; the command ends with that
     * @return this command
     * @throws IllegalStateException if it was accepted before
     */
    public synchronized QueuedCommand checkedBy(Runnable further) {
        requireNew();
        Runnable before = check;
        check = () -> {
            further.run();
            before.run();
        };
        return this;
    }

    /**
     * Sets a receiver of its end, before the command is submitted.
     *
     * @param receiver called once after the command was submitted and has ended, with its answer, whose text is empty
     *     if the command answers nothing; called on the worker of the robot, or on the thread that ends the command
     * @return this command
     * @throws IllegalStateException if it was accepted before
     */
    public synchronized QueuedCommand endingIn(Consumer<Answer> receiver) {
        requireNew();
        ending = receiver;
        return this;
    }

    private void requireNew() {
        if (control != null) {
            throw new IllegalStateException(text + " was submitted before");
        }
    }

    /**
     * Returns the text of the command.
     *
     * @return the text without the robot, as answers repeat it
     */
    public String text() {
        return text;
    }

    /**
     * Returns whether the command may move the robot.
     *
     * @return true if it needs the robot to be free and no STOP latched
     */
    public boolean moves() {
        return moves;
    }

    @Nullable
    Object asker() {
        return asker;
    }

    /**
     * Returns how the command ended; set before any listener is called.
     *
     * @return null while it has not ended
     */
    public Answer.@Nullable Outcome outcome() {
        return outcome;
    }

    /**
     * Returns whether the command has ended, with any outcome, and its answer was given.
     *
     * @return true from then on; {@link #outcome()} returns how
     */
    public boolean hasEnded() {
        return ended;
    }

    /**
     * Accepts the command.
     *
     * @param robot how it will use the robot
     * @throws IllegalStateException if it was accepted before
     */
    synchronized void accept(BotControl robot) {
        requireNew();
        control = robot;
    }

    /** Checks whether it may begin; throws a {@link BotException} if not. */
    void check() {
        check.run();
    }

    /** Runs the accepted command and returns its answers; blocks until it is done. */
    List<String> run() {
        return work.run(Objects.requireNonNull(control, "not submitted"));
    }

    void settle(Answer.Outcome how) {
        outcome = how;
    }

    void end(Answer answer) {
        outcome = answer.outcome();
        ended = true;
        try {
            ending.accept(answer);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "the receiver of the end of \"" + text + "\" failed", e);
        }
    }
}

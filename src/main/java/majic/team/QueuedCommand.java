package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Function;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MotionOrder;
import majic.bot.MotionReport;
import majic.driver.BotDriver;
import majic.driver.PermittedControl;
import org.jspecify.annotations.Nullable;

/**
 * A command to one robot, from its creation until it has ended: its text, what it does and, once it was accepted by
 * {@link Member#submit} or {@link Member#runNow}, how it ended. Is submitted once. Thread-safe; wait for its end at
 * {@link Team#changes()}.
 */
public final class QueuedCommand {
    private static final Logger LOG = System.getLogger(QueuedCommand.class.getName());
    private static final Runnable NOTHING = () -> {};

    private final String text;
    private final boolean moves;
    private final Runnable hold;
    private final Runnable check;
    private final Work work;
    private final @Nullable Object asker;
    private final Consumer<Answer> ending;
    private volatile @Nullable PermittedControl control;
    private volatile boolean checked;
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
        this(text, moves, NOTHING, NOTHING, work, null, answer -> {});
    }

    private QueuedCommand(
            String text,
            boolean moves,
            Runnable hold,
            Runnable check,
            Work work,
            @Nullable Object asker,
            Consumer<Answer> ending) {
        this.text = text;
        this.moves = moves;
        this.hold = hold;
        this.check = check;
        this.work = work;
        this.asker = asker;
        this.ending = ending;
    }

    /**
     * Creates a command that is one motion. If the robot {@link BotDriver#queuesCommands() queues} what is sent to it,
     * nothing waits in its queue and the command need not be held, then the thread that submits the command sends it.
     *
     * @param text the command without the robot, as answers repeat it
     * @param order what to do
     * @param until ends the motion early
     * @param answers makes the answers, each without the robot's number
     * @return a command that was not submitted yet, without an asker
     */
    public static QueuedCommand motion(
            String text, MotionOrder order, Guard until, Function<MotionReport, List<String>> answers) {
        return new QueuedCommand(text, true, new MotionWork(order, until, answers));
    }

    /**
     * Returns the same command, not submitted, with an asker.
     *
     * @param by returned with the answers, so that they can be routed to the source of the command; null for no
     *     particular source
     * @return a new command
     */
    public QueuedCommand askedBy(@Nullable Object by) {
        return new QueuedCommand(text, moves, hold, check, work, by, ending);
    }

    /**
     * Returns the same command, not submitted, which may be held when its turn comes.
     *
     * @param until blocks until the command may begin; throws a {@link BotException} if it must not
     * @return a new command
     */
    public QueuedCommand heldUntil(Runnable until) {
        return new QueuedCommand(text, moves, until, check, work, asker, ending);
    }

    /**
     * Returns the same command, not submitted, with a further check that is made when its turn comes and nothing holds
     * it.
     *
     * @param further must not wait; throws a {@link BotException} if the command must not begin; the command ends with that
     * @return a new command
     */
    public QueuedCommand checkedBy(Runnable further) {
        Runnable all = () -> {
            further.run();
            check.run();
        };
        return new QueuedCommand(text, moves, hold, all, work, asker, ending);
    }

    /**
     * Returns the same command, not submitted, with a receiver of its end.
     *
     * @param receiver called once after the command was submitted and has ended, with its answer, whose text is empty if
     *     the command answers nothing; called on the worker of the robot, or on the thread that ends the command
     * @return a new command
     */
    public QueuedCommand endingIn(Consumer<Answer> receiver) {
        return new QueuedCommand(text, moves, hold, check, work, asker, receiver);
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
     *
     * @throws IllegalStateException if it was accepted before
     */
    synchronized void accept(PermittedControl robot) {
        if (control != null) {
            throw new IllegalStateException(text + " was submitted before");
        }
        control = robot;
    }

    /** Returns whether the thread that submits it may begin it: it need not be held, and is a motion. */
    boolean canBeginAhead() {
        return hold == NOTHING && work instanceof MotionWork;
    }

    /**
     * Checks it and begins its motion, if nothing has to be waited for. What it throws, {@link #check} or {@link #run}
     * throws.
     */
    void beginAhead() {
        check();
        if (work instanceof MotionWork motion) {
            motion.begin(Objects.requireNonNull(control, "not submitted"));
        }
    }

    /** Waits until it may begin; throws a {@link BotException} if it must not. Makes each check once. */
    void check() {
        if (!checked) {
            hold.run();
            check.run();
            checked = true;
        }
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

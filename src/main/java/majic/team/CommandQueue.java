package majic.team;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/** Runs the commands to one robot one after the other, on a thread of its own. Thread-safe. */
final class CommandQueue {
    private final Team team;
    private final int robot;
    private final MajicBot bot;
    private final BooleanSupplier mayWork;
    private final Signal work;
    private final Deque<QueuedCommand> queue = new ArrayDeque<>();
    private @Nullable QueuedCommand current;
    private @Nullable Thread worker;
    private boolean closed;

    /**
     * Creates an empty queue.
     *
     * @param team receives the answers
     * @param robot the robot's number in the team
     * @param bot the robot
     * @param mayWork whether a command may be begun now; evaluated again after {@link #wake()}
     */
    CommandQueue(Team team, int robot, MajicBot bot, BooleanSupplier mayWork) {
        this.team = team;
        this.robot = robot;
        this.bot = bot;
        this.mayWork = mayWork;
        this.work = bot.time().signal();
    }

    void start(String thread) {
        Thread begun = bot.time().thread(thread, this::work);
        synchronized (this) {
            worker = begun;
        }
        begun.start();
    }

    synchronized boolean isIdle() {
        return queue.isEmpty() && current == null;
    }

    /** Whether no command is running, or only the one that calls this. */
    synchronized boolean isAtRest() {
        return current == null || Thread.currentThread() == worker;
    }

    synchronized boolean hasRoom() {
        return queue.size() < Member.QUEUE_DEPTH;
    }

    synchronized void add(QueuedCommand command) {
        queue.add(command);
    }

    /** Makes the thread check again whether it may work; must not be called while holding a lock. */
    void wake() {
        work.raise();
    }

    /** Removes all commands that were not begun. */
    synchronized List<QueuedCommand> drop() {
        List<QueuedCommand> dropped = new ArrayList<>(queue);
        queue.clear();
        return dropped;
    }

    /** Reports dropped commands as not carried out. */
    void tellDropped(List<QueuedCommand> dropped, String because) {
        dropped.forEach(command -> tell(command, Ending.of(Answer.Outcome.NOT_RUN, command, "not run: " + because)));
    }

    /** Begins no further command, and ends the thread. */
    void close() {
        synchronized (this) {
            closed = true;
        }
        work.raise();
    }

    private void work() {
        try {
            while (!isClosed()) {
                work.await(() -> isClosed() || (mayWork.getAsBoolean() && hasCommands()), Signal.FOR_EVER);
                QueuedCommand next = next();
                if (next != null) {
                    settle(next, attempt(next));
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    private synchronized boolean hasCommands() {
        return !queue.isEmpty();
    }

    private synchronized @Nullable QueuedCommand next() {
        current = closed ? null : queue.poll();
        return current;
    }

    /** Runs a command outside the queue, so its failure drops no queued command. */
    void runBeside(QueuedCommand command) {
        tell(command, attempt(command));
    }

    /** A failed command drops what is queued behind it by then; commands submitted in response to the failure run. */
    private void settle(QueuedCommand command, Ending ending) {
        List<QueuedCommand> dropped = List.of();
        if (ending.outcome() == Answer.Outcome.FAILED) {
            synchronized (this) {
                dropped = drop();
                command.settle(ending.outcome());
            }
        }
        tell(command, ending);
        tellDropped(dropped, robot + " " + command.text() + " failed");
        synchronized (this) {
            current = null;
        }
        team.changes().raise();
    }

    private Ending attempt(QueuedCommand command) {
        try {
            return new Ending(Answer.Outcome.DONE, command.run(bot));
        } catch (MotionStopped e) {
            return Ending.of(Answer.Outcome.STOPPED, command, "stopped");
        } catch (BotException e) {
            return Ending.of(Answer.Outcome.FAILED, command, "failed: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.ERROR, "a command to robot " + robot + " failed", e);
            return Ending.of(Answer.Outcome.FAILED, command, "failed: an error in MAJIC, see its log");
        }
    }

    private void tell(QueuedCommand command, Ending ending) {
        Object asker = command.asker();
        ending.answers().forEach(line -> team.answer(new Answer(robot, ending.outcome(), robot + " " + line, asker)));
        command.end(ending.outcome());
        team.changes().raise();
    }

    /** How a command ended, and the answers to report for it. */
    private record Ending(Answer.Outcome outcome, List<String> answers) {
        static Ending of(Answer.Outcome outcome, QueuedCommand command, String how) {
            return new Ending(outcome, List.of(command.text() + ": " + how));
        }
    }
}

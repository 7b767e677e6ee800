package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.text.ClassReason;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Runs the commands to one robot one after the other, on a thread of its own. Thread-safe. */
final class CommandQueue {
    /** How many commands may wait in a queue. */
    static final int DEPTH = 100;

    private static final Logger LOG = System.getLogger(CommandQueue.class.getName());

    private final int robot;
    private final TimeSource time;
    private final TeamEvents events;
    private final List<CommandListener> listeners;
    private final Object lock;
    private final BooleanSupplier mayWork;
    private final Signal work;
    private final Deque<QueuedCommand> queue = new ArrayDeque<>();
    private @Nullable QueuedCommand current;
    private @Nullable Thread worker;
    private boolean closed;

    /**
     * Creates an empty queue.
     *
     * @param robot the robot's number in the team
     * @param time the robot's clock
     * @param events receives the answers
     * @param lock guards what {@code mayWork} depends on; taken before the lock of this queue
     * @param mayWork whether a command may begin now; evaluated again after {@link #wake()}
     */
    CommandQueue(int robot, TimeSource time, TeamEvents events, Object lock, BooleanSupplier mayWork) {
        this.robot = robot;
        this.time = time;
        this.events = events;
        this.listeners = events.commandListeners();
        this.lock = lock;
        this.mayWork = mayWork;
        this.work = time.signal();
    }

    void start(String thread) {
        Thread begun = time.thread(thread, this::work);
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
        return queue.size() < DEPTH;
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

    /** Answers commands that were removed from the queue, though no stop has removed them. */
    void answerNotRun(List<QueuedCommand> commands, String because) {
        answerRemoved(commands, Answer.Outcome.NOT_RUN, because);
    }

    /** Answers commands that a stop has removed from the queue. */
    void answerStopped(List<QueuedCommand> commands) {
        answerRemoved(commands, Answer.Outcome.STOPPED, "stopped");
    }

    private void answerRemoved(List<QueuedCommand> commands, Answer.Outcome outcome, String because) {
        commands.forEach(command -> end(command, Ending.of(outcome, command, "not run: " + because)));
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
                    settle(next, attempt(next, listeners));
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

    /** Takes the next command out of the queue; no stop can come between this and the check that it may begin. */
    private @Nullable QueuedCommand next() {
        synchronized (lock) {
            return mayWork.getAsBoolean() ? poll() : null;
        }
    }

    private synchronized @Nullable QueuedCommand poll() {
        current = closed ? null : queue.poll();
        return current;
    }

    /** Runs a command beside the queue: its failure drops no queued command. */
    void runBeside(QueuedCommand command) {
        end(command, attempt(command, List.of()));
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
        end(command, ending);
        answerNotRun(dropped, robot + " " + command.text() + " failed");
        synchronized (this) {
            current = null;
        }
        events.changes().raise();
    }

    private Ending attempt(QueuedCommand command, List<CommandListener> receivers) {
        boolean begun = false;
        try {
            command.check();
            begun = true;
            for (CommandListener listener : receivers) {
                reportBegun(listener, command);
            }
            return new Ending(Answer.Outcome.DONE, command.run());
        } catch (MotionStopped e) {
            return Ending.of(Answer.Outcome.STOPPED, command, begun ? "stopped" : "not run: stopped");
        } catch (BotException e) {
            return Ending.of(Answer.Outcome.FAILED, command, "failed: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "a command to robot " + robot + " failed", e);
            return Ending.of(Answer.Outcome.FAILED, command, "failed: " + ClassReason.ofUnexpected(e));
        }
    }

    /** A listener that fails does not keep the command from being run. */
    private void reportBegun(CommandListener listener, QueuedCommand command) {
        try {
            listener.begun(robot, command.text());
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "a listener to the commands of robot " + robot + " failed", e);
        }
    }

    private void end(QueuedCommand command, Ending ending) {
        Object asker = command.asker();
        ending.answers().forEach(line -> events.answer(new Answer(robot, ending.outcome(), robot + " " + line, asker)));
        command.end(new Answer(robot, ending.outcome(), String.join("; ", ending.answers()), asker));
        events.changes().raise();
    }

    /** How a command ended, and the answers to report for it. */
    private record Ending(Answer.Outcome outcome, List<String> answers) {
        static Ending of(Answer.Outcome outcome, QueuedCommand command, String how) {
            return new Ending(outcome, List.of(command.text() + ": " + how));
        }
    }
}

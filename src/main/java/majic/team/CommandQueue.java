package majic.team;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.BooleanSupplier;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.PermittedControl;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/** Orders to one robot that are carried out one after the other, by a thread of their own. Thread-safe. */
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
     * An empty lane.
     *
     * @param team hears the answers
     * @param robot its number in it
     * @param bot the robot
     * @param mayWork whether an order may be begun now; asked again after {@link #wake()}
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

    /** Whether no order is under way, or only the one that asks. */
    synchronized boolean isAtRest() {
        return current == null || Thread.currentThread() == worker;
    }

    synchronized boolean hasRoom() {
        return queue.size() < Member.QUEUE_DEPTH;
    }

    synchronized void add(QueuedCommand pending) {
        queue.add(pending);
    }

    /** Lets the thread look again whether it may work; not to be called with a lock in hand. */
    void wake() {
        work.raise();
    }

    /** Takes out all orders that were not begun. */
    synchronized List<QueuedCommand> drop() {
        List<QueuedCommand> dropped = new ArrayList<>(queue);
        queue.clear();
        return dropped;
    }

    /** Says of orders that were dropped that they are not carried out. */
    void tellDropped(List<QueuedCommand> dropped, String because) {
        dropped.forEach(pending -> tell(pending, Ending.of(Answer.Outcome.NOT_RUN, pending, "not run: " + because)));
    }

    /** Begins no further order, and lets the thread go. */
    void close() {
        synchronized (this) {
            closed = true;
        }
        work.raise();
    }

    private void work() {
        try {
            while (!isClosed()) {
                work.await(() -> isClosed() || (mayWork.getAsBoolean() && hasOrders()), Signal.FOR_EVER);
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

    private synchronized boolean hasOrders() {
        return !queue.isEmpty();
    }

    private synchronized @Nullable QueuedCommand next() {
        current = closed ? null : queue.poll();
        return current;
    }

    /** Carries out an order that does not stand in the queue, so nothing stands behind it. */
    void carryOut(QueuedCommand pending) {
        tell(pending, attempt(pending));
    }

    /** What failed takes along what is queued behind it by then; what is ordered in answer to the failure runs. */
    private void settle(QueuedCommand pending, Ending ending) {
        List<QueuedCommand> dropped = List.of();
        if (ending.outcome() == Answer.Outcome.FAILED) {
            synchronized (this) {
                dropped = drop();
                pending.settle(ending.outcome());
            }
        }
        tell(pending, ending);
        tellDropped(dropped, robot + " " + pending.order().text() + " failed");
        synchronized (this) {
            current = null;
        }
        team.changes().raise();
    }

    private Ending attempt(QueuedCommand pending) {
        try {
            BotControl control = new PermittedControl(bot, pending::permit);
            List<String> answers = pending.order().job().carryOut(control);
            return new Ending(Answer.Outcome.DONE, answers);
        } catch (MotionStopped e) {
            return Ending.of(Answer.Outcome.STOPPED, pending, "stopped");
        } catch (BotException e) {
            return Ending.of(Answer.Outcome.FAILED, pending, "failed: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.ERROR, "an order to robot " + robot + " failed", e);
            return Ending.of(Answer.Outcome.FAILED, pending, "failed: an error in MAJIC, see its log");
        }
    }

    private void tell(QueuedCommand pending, Ending ending) {
        Object asker = pending.order().asker();
        ending.answers().forEach(line -> team.answer(new Answer(robot, ending.outcome(), robot + " " + line, asker)));
        pending.end(ending.outcome());
        team.changes().raise();
    }

    /** How an order ended, and what is to be said of it. */
    private record Ending(Answer.Outcome outcome, List<String> answers) {
        static Ending of(Answer.Outcome outcome, QueuedCommand pending, String how) {
            return new Ending(outcome, List.of(pending.order().text() + ": " + how));
        }
    }
}

package majic.bot;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/** Orders to one robot that are carried out one after the other, by a thread of their own. Thread-safe. */
final class Lane {
    private final Team team;
    private final int robot;
    private final MajicBot bot;
    private final BooleanSupplier mayWork;
    private final Signal work;
    private final Deque<Pending> queue = new ArrayDeque<>();
    private @Nullable Pending current;
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
    Lane(Team team, int robot, MajicBot bot, BooleanSupplier mayWork) {
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

    synchronized void add(Pending pending) {
        queue.add(pending);
    }

    /** Lets the thread look again whether it may work; not to be called with a lock in hand. */
    void wake() {
        work.raise();
    }

    /** Takes out all orders that were not begun. */
    synchronized List<Pending> drop() {
        List<Pending> dropped = new ArrayList<>(queue);
        queue.clear();
        return dropped;
    }

    /** Says of orders that were dropped that they are not carried out. */
    void tellDropped(List<Pending> dropped, String because) {
        dropped.forEach(pending -> end(pending, Answer.Outcome.NOT_RUN, "not run: " + because));
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
                Pending next = next();
                if (next != null) {
                    finish(next, carryOut(next));
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

    private synchronized @Nullable Pending next() {
        current = closed ? null : queue.poll();
        return current;
    }

    /** What failed takes along what was queued behind it. */
    private void finish(Pending done, Answer.Outcome outcome) {
        List<Pending> dropped;
        synchronized (this) {
            current = null;
            dropped = outcome == Answer.Outcome.FAILED ? drop() : List.of();
        }
        tellDropped(dropped, robot + " " + done.order().text() + " failed");
        team.changes().raise();
    }

    Answer.Outcome carryOut(Pending pending) {
        try {
            BotControl control = new PermittedControl(bot, pending::permit);
            List<String> answers = pending.order().job().carryOut(control);
            answers.forEach(line -> team.answer(new Answer(robot, Answer.Outcome.DONE, robot + " " + line)));
            pending.end(Answer.Outcome.DONE);
            team.changes().raise();
        } catch (MotionStopped e) {
            end(pending, Answer.Outcome.STOPPED, "stopped");
        } catch (BotException e) {
            end(pending, Answer.Outcome.FAILED, "failed: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.ERROR, "an order to robot " + robot + " failed", e);
            end(pending, Answer.Outcome.FAILED, "failed: an error in MAJIC, see its log (" + e + ")");
        }
        return Objects.requireNonNull(pending.outcome());
    }

    private void end(Pending pending, Answer.Outcome outcome, String how) {
        team.answer(new Answer(robot, outcome, robot + " " + pending.order().text() + ": " + how));
        pending.end(outcome);
        team.changes().raise();
    }
}

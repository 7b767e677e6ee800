package majic.bot;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A robot in a team: its number, its queue with the one worker that empties it, its owner. Thread-safe.
 */
public final class Member {
    /** How many orders may wait for one robot. */
    public static final int QUEUE_DEPTH = 100;

    private final Team team;
    private final int number;
    private final MajicBot bot;
    private final Signal work;
    private final Deque<Pending> queue = new ArrayDeque<>();
    private @Nullable Pending current;
    private @Nullable Owner owner;
    private int stopsUnderWay;
    private boolean closed;

    Member(Team team, int number, MajicBot bot) {
        this.team = team;
        this.number = number;
        this.bot = bot;
        this.work = bot.time().signal();
    }

    /**
     * Its number.
     *
     * @return 1 to the size of the team
     */
    public int number() {
        return number;
    }

    /**
     * The robot.
     *
     * @return its driver
     */
    public MajicBot bot() {
        return bot;
    }

    /**
     * The clock the robot lives by.
     *
     * @return the lab's for a simulated robot, otherwise the system's
     */
    public TimeSource time() {
        return bot.time();
    }

    /**
     * Who has it to himself.
     *
     * @return null if nobody
     */
    public synchronized @Nullable Owner owner() {
        return owner;
    }

    /**
     * Whether it has nothing to do and nothing to wait for.
     *
     * @return true when the queue is empty and no order or stop is under way
     */
    public synchronized boolean isIdle() {
        return queue.isEmpty() && current == null && stopsUnderWay == 0;
    }

    /**
     * Whether a stop is on its way to it.
     *
     * @return true until the robot was told and has confirmed it
     */
    public synchronized boolean isStopping() {
        return stopsUnderWay > 0;
    }

    /**
     * Whether another order would be accepted.
     *
     * @return false while the queue is full
     */
    public synchronized boolean hasRoom() {
        return queue.size() < QUEUE_DEPTH;
    }

    /**
     * Checks what {@link #submit} checks, and orders nothing.
     *
     * @param moves whether the order would move the robot
     * @param by who would give it; null for a person at the command line
     * @throws BotException what {@link #submit} would throw now
     */
    public synchronized void check(boolean moves, @Nullable Owner by) {
        if (moves) {
            team.checkLatch();
            if (owner != null && owner != by) {
                throw owner.inTheWay(number);
            }
        }
        if (!hasRoom()) {
            throw new BotException(number + ": its queue is full (" + QUEUE_DEPTH + " commands); wait, or \"" + number
                    + " stop\" empties it");
        }
    }

    /**
     * Puts an order at the end of the queue.
     *
     * @param order what to do
     * @param by who gives it; null for a person at the command line
     * @return the order under way
     * @throws BotException if the queue is full, or the order moves and the robot has another owner or STOP is latched;
     *     nothing was queued then
     */
    public Pending submit(Order order, @Nullable Owner by) {
        Pending pending;
        synchronized (this) {
            check(order.moves(), by);
            pending = new Pending(order, bot.permit());
            queue.add(pending);
        }
        work.raise();
        return pending;
    }

    /**
     * Carries an order out at once, beside the queue, on a thread of its own: a {@code get} at the prompt.
     *
     * @param order what to do; must not move the robot
     * @return the order under way
     */
    public Pending runNow(Order order) {
        Pending pending = new Pending(order, bot.permit());
        bot.time()
                .thread("robot " + number + " " + order.text(), () -> carryOut(pending))
                .start();
        return pending;
    }

    /**
     * Takes the robot to oneself.
     *
     * @param newOwner who; allowed again for the same
     * @throws BotException if it has another owner already
     */
    public void claim(Owner newOwner) {
        synchronized (this) {
            if (owner != null && owner != newOwner) {
                throw owner.inTheWay(number);
            }
            owner = newOwner;
        }
        team.tell(listener -> listener.ownerChanged(this));
    }

    /**
     * Gives the robot back.
     *
     * @param oldOwner who had it; nothing happens if it is somebody else's by now
     */
    public void free(Owner oldOwner) {
        synchronized (this) {
            if (owner != oldOwner) {
                return;
            }
            owner = null;
        }
        team.changes().raise();
        team.tell(listener -> listener.ownerChanged(this));
    }

    /**
     * The robot in the hands of an owner, for calls past the queue.
     *
     * @param lease the owner's leave; revoking it makes every further motion throw
     * @return the robot
     */
    public BotControl control(Permit lease) {
        return new PermittedControl(bot, () -> bot.permit().and(lease));
    }

    /** Says what went wrong beside the queue. */
    void complain(BotException problem) {
        team.tell(listener -> listener.noticed(number, number + ": " + problem.getMessage()));
    }

    void start() {
        bot.time().thread("robot " + number + " worker", this::work).start();
    }

    /** Empties the queue and forbids the worker to go on until {@link #stopEnded}. */
    void stopBegins(@Nullable Owner by) {
        List<Pending> dropped;
        Owner ended;
        synchronized (this) {
            stopsUnderWay++;
            if (team.isLatched()) {
                bot.latch();
            } else {
                bot.revokeMotions();
            }
            dropped = new ArrayList<>(queue);
            queue.clear();
            ended = owner != by ? owner : null;
        }
        dropped.forEach(pending -> end(pending, Answer.Outcome.NOT_RUN, "not run: stopped"));
        if (ended != null) {
            end(ended);
        }
    }

    /** Allows motion again, unless STOP came anew meanwhile. */
    synchronized void release() {
        if (!team.isLatched()) {
            bot.unlatch();
        }
    }

    private void end(Owner ended) {
        try {
            ended.end();
        } catch (RuntimeException e) {
            Team.LOG.log(System.Logger.Level.ERROR, ended.name() + " did not end well", e);
        }
    }

    /** Lets no robot seem idle before everybody has heard of a STOP; {@link #stopEnded} ends it. */
    synchronized void holdWork() {
        stopsUnderWay++;
    }

    void stopEnded() {
        synchronized (this) {
            stopsUnderWay--;
        }
        work.raise();
        team.changes().raise();
    }

    void close() {
        synchronized (this) {
            closed = true;
        }
        work.raise();
        bot.close();
    }

    private void work() {
        try {
            while (true) {
                work.await(this::mayWork, Signal.FOR_EVER);
                Pending next = next();
                if (next == null) {
                    return;
                }
                Answer.Outcome outcome = carryOut(next);
                finish(next, outcome);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean mayWork() {
        return closed || (stopsUnderWay == 0 && !queue.isEmpty());
    }

    private synchronized @Nullable Pending next() {
        current = closed ? null : queue.poll();
        return current;
    }

    /** What failed takes along what was queued behind it. */
    private void finish(Pending done, Answer.Outcome outcome) {
        List<Pending> dropped = List.of();
        synchronized (this) {
            current = null;
            if (outcome == Answer.Outcome.FAILED) {
                dropped = new ArrayList<>(queue);
                queue.clear();
            }
        }
        String because = "not run: " + number + " " + done.order().text() + " failed";
        dropped.forEach(pending -> end(pending, Answer.Outcome.NOT_RUN, because));
        team.changes().raise();
    }

    private Answer.Outcome carryOut(Pending pending) {
        try {
            BotControl robot = new PermittedControl(bot, pending::permit);
            List<String> answers = pending.order().job().carryOut(robot);
            answers.forEach(line -> team.answer(new Answer(number, Answer.Outcome.DONE, number + " " + line)));
            pending.end(Answer.Outcome.DONE);
            team.changes().raise();
        } catch (MotionStopped e) {
            end(pending, Answer.Outcome.STOPPED, "stopped");
        } catch (BotException e) {
            end(pending, Answer.Outcome.FAILED, "failed: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.ERROR, "an order to robot " + number + " failed", e);
            end(pending, Answer.Outcome.FAILED, "failed: an error in MAJIC, see its log (" + e + ")");
        }
        return Objects.requireNonNull(pending.outcome());
    }

    private void end(Pending pending, Answer.Outcome outcome, String how) {
        team.answer(new Answer(number, outcome, number + " " + pending.order().text() + ": " + how));
        pending.end(outcome);
        team.changes().raise();
    }
}

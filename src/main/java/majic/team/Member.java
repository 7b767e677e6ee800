package majic.team;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import majic.bot.TeamPlace;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A robot in a team: its number, its queue with the one worker that empties it, its owner, and the act it is lent to.
 * Thread-safe.
 */
public final class Member implements TeamPlace {
    /** How many orders may wait for one robot. */
    public static final int QUEUE_DEPTH = 100;

    /** How many orders may be carried out beside the queue of one robot, each on a thread of its own. */
    private static final int MOST_BESIDE = 16;

    private final Team team;
    private final int number;
    private final MajicBot bot;
    private final CommandQueue lane;
    private final Tenure tenure;
    private final Stops stops;
    private final AtomicInteger beside = new AtomicInteger();
    private boolean gone;

    Member(Team team, int number, MajicBot bot) {
        this.team = team;
        this.number = number;
        this.bot = bot;
        this.lane = new CommandQueue(team, number, bot, () -> mayWork(null));
        this.tenure = new Tenure(number);
        this.stops = new Stops(team, bot, lane, tenure);
    }

    /**
     * The member that a robot is.
     *
     * @param bot a robot
     * @return empty for a robot that is used alone
     */
    public static Optional<Member> of(MajicBot bot) {
        return bot.place().map(Member.class::cast);
    }

    @Override
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
     * @return who it is lent to, otherwise its owner; null if nobody
     */
    public synchronized @Nullable Owner owner() {
        return tenure.holder();
    }

    /**
     * Whether it has nothing to do and nothing to wait for.
     *
     * @return true when the queue is empty, no order or stop is under way, and it is not lent to anybody
     */
    public synchronized boolean isIdle() {
        return tenure.loan() == null && lane.isIdle() && !stops.areUnderWay();
    }

    /**
     * Whether it has done all that somebody told it.
     *
     * @param by who; only for the one it is lent to it makes a difference to {@link #isIdle()}
     * @return true when no order of his, and no stop, is under way
     */
    public synchronized boolean isIdle(@Nullable Owner by) {
        Loan his = tenure.loanTo(by);
        return his != null ? his.lane().isIdle() && !stops.areUnderWay() : isIdle();
    }

    /**
     * Whether a stop is on its way to it.
     *
     * @return true until the robot was told and has confirmed it
     */
    public synchronized boolean isStopping() {
        return stops.areUnderWay();
    }

    /**
     * Whether an owner that was ended by a stop has not given the robot back yet.
     *
     * @return true from the stop until the robot is given back
     */
    public boolean hasDismissedOwner() {
        Owner holder = owner();
        return holder != null && holder.isDismissed();
    }

    /**
     * Whether another order would be accepted.
     *
     * @return false while the queue is full
     */
    public boolean hasRoom() {
        return hasRoom(null);
    }

    /**
     * Whether another order of somebody would be accepted.
     *
     * @param by who; only for the one it is lent to it makes a difference to {@link #hasRoom()}
     * @return false while his queue is full
     */
    public synchronized boolean hasRoom(@Nullable Owner by) {
        return laneOf(by).hasRoom();
    }

    private CommandQueue laneOf(@Nullable Owner by) {
        Loan his = tenure.loanTo(by);
        return his != null ? his.lane() : lane;
    }

    /**
     * The leave that orders are given by now, for whoever begins something later that belongs to this moment.
     *
     * @return revoked by the next stop, or when the link is lost
     */
    public Permit leave() {
        return bot.permit().and(new Permit());
    }

    private Permit leaveOf(@Nullable Owner by) {
        Loan his = tenure.loanTo(by);
        return his != null ? his.leave(bot) : bot.permit();
    }

    /**
     * Checks what {@link #submit} checks, and orders nothing.
     *
     * @param moves whether the order would move the robot
     * @param by who would give it; null for a person at the command line
     * @throws BotException what {@link #submit} would throw now
     */
    public synchronized void check(boolean moves, @Nullable Owner by) {
        if (gone) {
            throw new BotException(number + ": robot " + number + " was removed");
        }
        if (moves) {
            team.checkLatch();
            tenure.check(by);
        }
        if (!hasRoom(by)) {
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
     * @throws MotionStopped if the order moves and who gives it was ended, or has the robot no more; nothing was queued
     */
    public QueuedCommand submit(Order order, @Nullable Owner by) {
        QueuedCommand pending;
        CommandQueue used;
        synchronized (this) {
            check(order.moves(), by);
            pending = new QueuedCommand(order, leaveOf(by));
            used = laneOf(by);
            used.add(pending);
        }
        used.wake();
        return pending;
    }

    /**
     * Carries an order out at once, beside the queue, on a thread of its own: a {@code get} at the prompt.
     *
     * @param order what to do; must not move the robot
     * @return the order under way
     * @throws BotException if {@value #MOST_BESIDE} such orders have not ended yet
     */
    public QueuedCommand runNow(Order order) {
        if (beside.incrementAndGet() > MOST_BESIDE) {
            beside.decrementAndGet();
            throw new BotException(number + ": " + MOST_BESIDE + " commands beside its queue have no answer yet; wait");
        }
        QueuedCommand pending = new QueuedCommand(order, bot.permit());
        startBeside(pending);
        return pending;
    }

    private void startBeside(QueuedCommand pending) {
        Runnable body = () -> {
            try {
                lane.carryOut(pending);
            } finally {
                beside.decrementAndGet();
            }
        };
        try {
            bot.time()
                    .thread("robot " + number + " " + pending.order().text(), body)
                    .start();
        } catch (RuntimeException | Error e) {
            beside.decrementAndGet();
            throw e;
        }
    }

    /**
     * Takes the robot to oneself.
     *
     * @param newOwner who; allowed again for the same
     * @throws BotException if it has another owner already
     */
    public void claim(Owner newOwner) {
        synchronized (this) {
            tenure.claim(newOwner);
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
            if (!tenure.free(oldOwner)) {
                return;
            }
        }
        team.changes().raise();
        team.tell(listener -> listener.ownerChanged(this));
    }

    /**
     * Who gets it back when a loan ends.
     *
     * @return the owner of a robot that is lent; null if it is not lent, or has no owner
     */
    public synchronized @Nullable Owner lender() {
        return tenure.lender();
    }

    /**
     * Lends the robot: until {@link #takeBack} only his orders are carried out, and those of its owner wait.
     *
     * @param to who gets it
     * @param lease the leave that his orders are carried out by, for as long as it holds; a stop revokes it
     * @param by the owner, who stays that; null if it has none
     * @throws BotException if it is somebody else's, or lent already, or a stop is on its way to it, or it still carries
     *     out an order, other than the one that lends it
     */
    public void lend(Owner to, Permit lease, @Nullable Owner by) {
        Loan begun = new Loan(to, lease, new CommandQueue(team, number, bot, () -> mayWork(to)));
        synchronized (this) {
            if (tenure.holder() == by && (stops.areUnderWay() || !lane.isAtRest())) {
                throw new BotException(number + " is still busy; \"" + number + " wait\" lets it finish first");
            }
            tenure.lend(begun, by);
        }
        begun.begin(number);
        team.tell(listener -> listener.ownerChanged(this));
    }

    /**
     * Ends a loan. What was still ordered under it is not carried out, and nothing is said of it. What is being carried
     * out ends with the lease: revoke that, and halt the robot, before.
     *
     * @param from who has it; nothing happens if he has not
     */
    public void takeBack(Owner from) {
        Loan ended;
        synchronized (this) {
            ended = tenure.takeBack(from);
        }
        if (ended == null) {
            return;
        }
        ended.close();
        lane.wake();
        team.changes().raise();
        team.tell(listener -> listener.ownerChanged(this));
    }

    /**
     * Tells what the one who has the robot says of his doings.
     *
     * @param from who
     * @param words half a sentence or a whole one
     */
    public void tell(Owner from, String words) {
        from.said(words);
        team.tell(listener -> listener.noticed(number, number + ": " + from.name() + ": " + words));
    }

    /**
     * Says to the person what went wrong beside the queue, as this robot's own words.
     *
     * @param problem its message is said
     */
    public void complain(BotException problem) {
        team.tell(listener -> listener.noticed(number, number + ": " + problem.getMessage()));
    }

    /** The clock of the team, which may be another than the robot's. */
    TimeSource teamTime() {
        return team.time();
    }

    /** Tells what was done by hand, once the robot was let go. */
    void tellByHand(List<ManualCommand> commands) {
        if (!commands.isEmpty()) {
            team.tell(listener -> listener.drivenByHand(this, commands));
        }
    }

    /** After a lost link nothing resumes by itself, not even when the robot is connected again. */
    @Override
    public void linkLost(String reason) {
        Loan ended;
        synchronized (this) {
            ended = tenure.loan();
        }
        if (ended != null) {
            ended.end(() -> new LinkLost(reason));
            bot.time().aside("ending " + ended.to().name(), ended.to()::endWhateverHappens);
        }
    }

    void start() {
        lane.start("robot " + number + " worker");
    }

    /**
     * Revokes, empties the queue and forbids the worker to go on until {@link #stopEnded} was called twice: when the
     * robot was stopped, and when everything was notified. Notifies nothing itself.
     */
    synchronized Stops.Aftermath stopBegins(@Nullable Owner by) {
        return stops.begin(by);
    }

    /** Allows motion again, unless STOP came anew meanwhile. */
    synchronized void release() {
        if (!team.isLatched()) {
            bot.unlatch();
        }
    }

    void stopEnded() {
        synchronized (this) {
            stops.end();
        }
        lanes().forEach(CommandQueue::wake);
        team.changes().raise();
    }

    private synchronized List<CommandQueue> lanes() {
        return tenure.lanes(lane);
    }

    private synchronized boolean mayWork(@Nullable Owner by) {
        return !stops.areUnderWay() && (tenure.loan() == null || tenure.loanTo(by) != null);
    }

    /** Closes the robot, then tells what of its queue is not run. */
    void close() {
        List<QueuedCommand> left;
        synchronized (this) {
            gone = true;
            left = lane.drop();
        }
        lanes().forEach(CommandQueue::close);
        try {
            bot.close();
        } finally {
            lane.tellDropped(left, "robot " + number + " was removed");
        }
    }
}

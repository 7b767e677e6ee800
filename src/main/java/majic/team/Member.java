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
 * A robot in a team: its number, its queue with the single worker thread, its owner, and the act it is lent to.
 * Thread-safe.
 */
public final class Member implements TeamPlace {
    /** How many commands may wait for one robot. */
    public static final int QUEUE_DEPTH = 100;

    /** How many commands may run outside the queue of one robot, each on a thread of its own. */
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
     * Returns the member for a robot.
     *
     * @param bot a robot
     * @return empty for a robot that is used without a team
     */
    public static Optional<Member> of(MajicBot bot) {
        return bot.place().map(Member.class::cast);
    }

    @Override
    public int number() {
        return number;
    }

    /**
     * Returns the robot.
     *
     * @return its driver
     */
    public MajicBot bot() {
        return bot;
    }

    /**
     * Returns the clock of the robot.
     *
     * @return the lab's for a simulated robot, otherwise the system's
     */
    public TimeSource time() {
        return bot.time();
    }

    /**
     * Returns the current holder of the robot.
     *
     * @return the borrower if it is lent, otherwise its owner; null if there is neither
     */
    public synchronized @Nullable Owner owner() {
        return tenure.holder();
    }

    /**
     * Returns whether the robot has no work and no pending stop.
     *
     * @return true when the queue is empty, no command or stop is running, and the robot is not lent
     */
    public synchronized boolean isIdle() {
        return tenure.loan() == null && lane.isIdle() && !stops.areUnderWay();
    }

    /**
     * Returns whether the robot has completed all commands of one source.
     *
     * @param by the source of the commands; differs from {@link #isIdle()} only for the borrower
     * @return true when no command from this source, and no stop, is running
     */
    public synchronized boolean isIdle(@Nullable Owner by) {
        Loan his = tenure.loanTo(by);
        return his != null ? his.lane().isIdle() && !stops.areUnderWay() : isIdle();
    }

    /**
     * Returns whether a stop of the robot is pending.
     *
     * @return true until the stop was sent to the robot and confirmed by it
     */
    public synchronized boolean isStopping() {
        return stops.areUnderWay();
    }

    /**
     * Returns whether an owner that was ended by a stop has not given the robot back yet.
     *
     * @return true from the stop until the robot is given back
     */
    public boolean hasDismissedOwner() {
        Owner holder = owner();
        return holder != null && holder.isDismissed();
    }

    /**
     * Returns whether another command would be accepted.
     *
     * @return false while the queue is full
     */
    public boolean hasRoom() {
        return hasRoom(null);
    }

    /**
     * Returns whether another command from one source would be accepted.
     *
     * @param by the source of the commands; differs from {@link #hasRoom()} only for the borrower
     * @return false while the queue of this source is full
     */
    public synchronized boolean hasRoom(@Nullable Owner by) {
        return laneOf(by).hasRoom();
    }

    private CommandQueue laneOf(@Nullable Owner by) {
        Loan his = tenure.loanTo(by);
        return his != null ? his.lane() : lane;
    }

    /**
     * Returns the current permission to move, for work that is requested now and started later.
     *
     * @return revoked by the next stop, or when the connection is lost
     */
    public Permit leave() {
        return bot.permit().and(new Permit());
    }

    private Permit leaveOf(@Nullable Owner by) {
        Loan his = tenure.loanTo(by);
        return his != null ? his.leave(bot) : bot.permit();
    }

    /**
     * Makes the checks of {@link #submit} without submitting a command.
     *
     * @param moves whether the command would move the robot
     * @param by the source of the command; null for a person at the command line
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
     * Puts a command at the end of the queue.
     *
     * @param command what to do
     * @param by the source of the command; null for a person at the command line
     * @throws BotException if the queue is full, or the command moves and the robot has another owner or STOP is latched;
     *     nothing was queued then
     * @throws MotionStopped if the command moves and its source was ended, or no longer has the robot; nothing was queued
     */
    public void submit(QueuedCommand command, @Nullable Owner by) {
        CommandQueue used;
        synchronized (this) {
            check(command.moves(), by);
            command.accept(leaveOf(by));
            used = laneOf(by);
            used.add(command);
        }
        used.wake();
    }

    /**
     * Runs a command at once, outside the queue, on a thread of its own: a {@code get} at the prompt.
     *
     * @param command what to do; must not move the robot
     * @throws BotException if {@value #MOST_BESIDE} such commands have not ended yet
     */
    public void runNow(QueuedCommand command) {
        if (beside.incrementAndGet() > MOST_BESIDE) {
            beside.decrementAndGet();
            throw new BotException(number + ": " + MOST_BESIDE + " commands beside its queue have no answer yet; wait");
        }
        try {
            command.accept(bot.permit());
            startBeside(command);
        } catch (RuntimeException | Error e) {
            beside.decrementAndGet();
            throw e;
        }
    }

    private void startBeside(QueuedCommand command) {
        Runnable body = () -> {
            try {
                lane.runBeside(command);
            } finally {
                beside.decrementAndGet();
            }
        };
        bot.time().thread("robot " + number + " " + command.text(), body).start();
    }

    /**
     * Makes a caller the owner of the robot.
     *
     * @param newOwner the new owner; may already be the owner
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
     * @param oldOwner the previous owner; has no effect if the robot has another owner by now
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
     * Returns the owner that gets the robot back when a loan ends.
     *
     * @return the owner of a robot that is lent; null if it is not lent, or has no owner
     */
    public synchronized @Nullable Owner lender() {
        return tenure.lender();
    }

    /**
     * Lends the robot: until {@link #takeBack} only the borrower's commands run, and those of the owner wait.
     *
     * @param to the borrower
     * @param lease the permission under which the borrower's commands run; a stop revokes it
     * @param by the owner, which remains the owner; null if there is none
     * @throws BotException if it has another owner, or is lent already, or a stop is pending, or it still runs a command
     *     other than the one that lends it
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
     * Ends a loan. Orders still queued under it are not run and not reported. The running command ends with the
     * permission: revoke the permission, and halt the robot, before this call.
     *
     * @param from the borrower; has no effect if the robot is not lent to it
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
     * Publishes a status message of the holder of the robot.
     *
     * @param from the holder
     * @param words half a sentence or a whole one
     */
    public void tell(Owner from, String words) {
        from.said(words);
        team.tell(listener -> listener.noticed(number, number + ": " + from.name() + ": " + words));
    }

    /**
     * Reports an error outside the queue to the user, as a message of this robot.
     *
     * @param problem its message is shown
     */
    public void complain(BotException problem) {
        team.tell(listener -> listener.noticed(number, number + ": " + problem.getMessage()));
    }

    /** The clock of the team, which may differ from the robot's. */
    TimeSource teamTime() {
        return team.time();
    }

    /** Reports the manual commands, once the robot was released. */
    void tellByHand(List<ManualCommand> commands) {
        if (!commands.isEmpty()) {
            team.tell(listener -> listener.drivenByHand(this, commands));
        }
    }

    /** After a lost connection nothing resumes by itself, not even when the robot is connected again. */
    @Override
    public void linkLost(String reason) {
        Loan ended;
        synchronized (this) {
            ended = tenure.loan();
        }
        if (ended != null) {
            ended.end(() -> new LinkLost(reason));
            bot.time().runAsync("ending " + ended.to().name(), ended.to()::endWhateverHappens);
        }
    }

    void start() {
        lane.start("robot " + number + " worker");
    }

    /**
     * Revokes the permission, empties the queue and blocks the worker until {@link #stopEnded} was called twice: when
     * the robot was stopped, and when all listeners were notified. Notifies nothing itself.
     */
    synchronized Stops.Aftermath stopBegins(@Nullable Owner by) {
        return stops.begin(by);
    }

    /** Allows motion again, unless another STOP came meanwhile. */
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

    /** Closes the robot, then reports the queued commands that are not run. */
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

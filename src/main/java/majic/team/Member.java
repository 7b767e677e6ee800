package majic.team;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.driver.BotDriver;
import majic.driver.Permit;
import majic.driver.TeamMembership;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** A robot in a team: its number, its queue with the single worker thread, and its owners. Thread-safe. */
public final class Member implements TeamMembership {
    /** How many commands may run beside the queue of one robot, each on a thread of its own. */
    private static final int MOST_BESIDE = 16;

    /** How long the end of a sublease waits for its last command, seconds of the team's clock. */
    private static final double LAST_COMMAND_S = 1;

    private final int number;
    private final BotDriver bot;
    private final TeamEvents events;
    private final Leases leases;
    private final AtomicInteger beside = new AtomicInteger();
    private volatile String name = "";

    /**
     * Creates the member; {@link #start} begins its work.
     *
     * @param stopIsLatched whether STOP is latched
     */
    Member(int number, BotDriver bot, TeamEvents events, BooleanSupplier stopIsLatched) {
        this.number = number;
        this.bot = bot;
        this.events = events;
        this.leases = new Leases(number, bot, events, stopIsLatched);
    }

    /**
     * Returns the member for a robot.
     *
     * @param bot a robot
     * @return empty for a robot that is used without a team
     */
    public static Optional<Member> of(MajicBot bot) {
        return BotDriver.of(bot).membership().map(Member.class::cast);
    }

    @Override
    public int number() {
        return number;
    }

    /**
     * Returns the name that the robot was given.
     *
     * @return one word; empty if it has none
     */
    public String name() {
        return name;
    }

    /** Names the robot; {@link Roster#rename} has checked the name. */
    void rename(String newName) {
        name = newName;
    }

    /**
     * Returns what users call the robot, beside its number.
     *
     * @return its name and kind, as in {@code Rex (Aibo)}; the kind alone if it has no name
     */
    public String label() {
        return label(name, bot.kind());
    }

    /**
     * Returns what users call a robot, beside its number.
     *
     * @param name its name; empty for none
     * @param type what kind of robot it is
     * @return as {@link #label()}
     */
    public static String label(String name, String type) {
        return name.isEmpty() ? type : name + " (" + type + ")";
    }

    /**
     * Returns the robot.
     *
     * @return its driver
     */
    public MajicBot bot() {
        return bot;
    }

    /** The robot as the team commands it. */
    BotDriver driver() {
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

    /** The clock of the team, which may differ from the robot's. */
    TimeSource teamTime() {
        return events.time();
    }

    /**
     * Returns the current owner of the robot: of several leases, that of the last.
     *
     * @return the act, if the robot is sublet to one; null if only users command it
     */
    public @Nullable Owner owner() {
        return leases.owner();
    }

    /**
     * Returns since when the robot has had its {@link #owner}.
     *
     * @return a time on the robot's clock; of no meaning while there is no owner
     */
    public long ownedSinceNanos() {
        return leases.ownedSinceNanos();
    }

    /**
     * Returns the owner that gets the robot back when a sublease ends, such as the script that runs the act.
     *
     * @return null if there is no sublease, or no owner below it
     */
    public @Nullable Owner sublessor() {
        return leases.sublessor();
    }

    /**
     * Returns whether the robot has no work and no pending stop.
     *
     * @return true when the queue is empty, no command or stop is running, and the robot is not sublet
     */
    public boolean isIdle() {
        return isIdle(null);
    }

    /**
     * Returns whether the robot has completed all commands of one source.
     *
     * @param by the source of the commands; differs from {@link #isIdle()} only for a sublease
     * @return true when no command from this source, and no stop, is running
     */
    public boolean isIdle(@Nullable Owner by) {
        return leases.isIdle(by);
    }

    /**
     * Returns whether a stop of the robot is pending.
     *
     * @return true until the stop was sent to the robot and confirmed by it
     */
    public boolean isStopping() {
        return leases.isStopping();
    }

    /**
     * Returns whether the owner was revoked, by a stop for instance, and has not given the robot back yet.
     *
     * @return true from the stop until the robot is given back
     */
    public boolean isOwnerRevoked() {
        Owner owner = owner();
        return owner != null && owner.isRevoked();
    }

    /**
     * Returns whether STOP of the team is latched.
     *
     * @return true until it is released; the robot must not move until then
     */
    public boolean isStopLatched() {
        return leases.isStopLatched();
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
     * @param by the source of the commands; differs from {@link #hasRoom()} only for a sublease
     * @return false while the queue of this source is full
     */
    public boolean hasRoom(@Nullable Owner by) {
        return leases.hasRoom(by);
    }

    /**
     * Returns the present permit to move, for work that is requested now and started later.
     *
     * @return a new permit, revoked by the next stop or when the connection is lost
     */
    public Permit currentPermit() {
        return bot.permit().and(new Permit());
    }

    /**
     * Makes the checks of {@link #submit} without submitting a command.
     *
     * @param moves whether the command would move the robot
     * @param by the source of the command; null for a user at the command line
     * @throws BotException what {@link #submit} would throw now
     */
    public void check(boolean moves, @Nullable Owner by) {
        leases.check(moves, by);
    }

    /**
     * Puts a command at the end of the queue.
     *
     * @param command what to do; not submitted before
     * @param by the source of the command; null for a user at the command line
     * @throws BotException if the queue is full, or the command moves and the robot has another owner or STOP is
     *     latched; nothing was queued then
     * @throws MotionStopped if the command moves and its source was ended, or no longer has the robot; nothing was
     *     queued
     * @throws IllegalStateException if the command was submitted before
     */
    public void submit(QueuedCommand command, @Nullable Owner by) {
        leases.submit(command, by);
    }

    /**
     * Runs a command at once, beside the queue, on a thread of its own: a {@code get} at the prompt.
     *
     * @param command what to do; must not move the robot; not submitted before
     * @throws BotException if {@value #MOST_BESIDE} such commands have not ended yet
     * @throws IllegalStateException if the command was submitted before
     */
    public void runNow(QueuedCommand command) {
        if (beside.incrementAndGet() > MOST_BESIDE) {
            beside.decrementAndGet();
            throw new BotException(number + ": " + MOST_BESIDE + " commands beside its queue have no answer yet; wait");
        }
        try {
            command.accept(leases.controlFor(null));
            bot.time()
                    .thread("robot " + number + " " + command.text(), () -> runBeside(command))
                    .start();
        } catch (RuntimeException | Error e) {
            beside.decrementAndGet();
            throw e;
        }
    }

    private void runBeside(QueuedCommand command) {
        try {
            leases.queue().runBeside(command);
        } finally {
            beside.decrementAndGet();
        }
    }

    /**
     * Makes a caller the owner of the robot.
     *
     * @param newOwner the new owner; may already be the owner
     * @throws BotException if it has another owner already
     */
    public void claim(Owner newOwner) {
        leases.claim(newOwner);
        events.publish(listener -> listener.ownerChanged(this));
    }

    /**
     * Gives the robot back.
     *
     * @param oldOwner the previous owner; has no effect if the robot has another owner by now
     */
    public void free(Owner oldOwner) {
        if (leases.free(oldOwner)) {
            publishGivenBack();
        }
    }

    private void publishGivenBack() {
        events.changes().raise();
        events.publish(listener -> listener.ownerChanged(this));
    }

    /**
     * Sublets the robot: until {@link #endSublease} only the commands of the new owner run, under its permit, and those
     * of the one below wait.
     *
     * @param to the new owner; a stop revokes its permit
     * @param by the owner below, which stays; null if there is none
     * @throws BotException if it has another owner, or is sublet already, or a stop is pending, or it still runs a
     *     command other than the one that sublets it
     */
    public void sublet(Owner to, @Nullable Owner by) {
        leases.sublet(to, by);
        events.publish(listener -> listener.ownerChanged(this));
    }

    /**
     * Ends a sublease. Commands still queued under it are not run and not answered. A running command ends with the
     * permit: revoke the permit, and halt the robot, before this call. Waits for that command for at most
     * {@value #LAST_COMMAND_S} s, so that nothing it sends reaches a robot that has been given back.
     *
     * @param of its owner; has no effect if that has no sublease of the robot
     */
    public void endSublease(Owner of) {
        CommandQueue closed = leases.closeSublease(of);
        if (closed == null) {
            return;
        }
        try {
            events.changes().await(closed::isAtRest, LAST_COMMAND_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (leases.endSublease(of)) {
            publishGivenBack();
        }
    }

    /**
     * Publishes a status message of the owner of the robot.
     *
     * @param from the owner
     * @param words half a sentence or a whole one
     */
    public void report(Owner from, String words) {
        from.status(words);
        notice(from.name() + ": " + words);
    }

    /**
     * Reports an error outside the queue to the user, as a message of this robot.
     *
     * @param problem its message is shown
     */
    public void report(BotException problem) {
        notice(String.valueOf(problem.getMessage()));
    }

    /**
     * Sends a message about the robot to the listeners of the team.
     *
     * @param words half a sentence or a whole one, without the robot's number
     */
    public void notice(String words) {
        events.publish(listener -> listener.noticed(number, number + ": " + words));
    }

    /** Reports the manual commands, once the robot was released. */
    void reportManual(List<ManualCommand> commands) {
        if (!commands.isEmpty()) {
            events.publish(listener -> listener.drivenManually(this, commands));
        }
    }

    /** After a lost connection nothing resumes by itself, not even when the robot is connected again. */
    @Override
    public void linkLost(String reason) {
        Owner act = leases.revokeSublease(() -> new LinkLost(reason));
        if (act != null) {
            bot.time().runAsync("ending " + act.name(), act::endLoggingErrors);
        }
    }

    /** As a stop by a user of this program, except that it has been sent already. */
    @Override
    public void stoppedElsewhere() {
        Leases.Stopped stopped = beginStop(null);
        events.changes().raise();
        bot.time().runAsync("ending what moved robot " + number, () -> {
            stopped.ended().forEach(Owner::endLoggingErrors);
            stopped.answer();
            endStop();
            endStop();
        });
    }

    void start() {
        leases.queue().start("robot " + number + " worker");
    }

    /** Revokes permits and empties the queues; see {@link Leases#beginStop}. Notifies nothing itself. */
    Leases.Stopped beginStop(@Nullable Owner by) {
        return leases.beginStop(by);
    }

    /** Ends one of the two parts of a stop; after both, commands run again. */
    void endStop() {
        leases.endStop();
        events.changes().raise();
    }

    /** Allows motion again, unless another STOP came meanwhile. */
    void release() {
        leases.release();
    }

    /** Closes the robot, then answers the queued commands, which are not run. */
    void close() {
        List<QueuedCommand> notRun = leases.remove();
        try {
            bot.close();
        } finally {
            leases.queue().answerNotRun(notRun, "robot " + number + " was removed");
        }
    }
}

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

/**
 * A robot in a team: its number, its queue with the single worker thread, its owner, and the act it is lent to.
 * Thread-safe.
 */
public final class Member implements TeamMembership {
    /** How many commands may run beside the queue of one robot, each on a thread of its own. */
    private static final int MOST_BESIDE = 16;

    /** How long the end of a loan waits for the borrower's last command, seconds of the team's clock. */
    private static final double LAST_COMMAND_S = 1;

    private final int number;
    private final BotDriver bot;
    private final TeamEvents events;
    private final Ownership ownership;
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
        this.ownership = new Ownership(number, bot, events, stopIsLatched);
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
     * @return its name and type, as in {@code Rex (Aibo)}; the type alone if it has no name
     */
    public String label() {
        return label(name, bot.type().label());
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
     * Returns the current holder of the robot.
     *
     * @return the borrower if it is lent, otherwise its owner; null if there is neither
     */
    public @Nullable Owner owner() {
        return ownership.holder();
    }

    /**
     * Returns since when the robot has had its {@link #owner}.
     *
     * @return a time on the robot's clock; of no meaning while there is no owner
     */
    public long ownedSinceNanos() {
        return ownership.heldSinceNanos();
    }

    /**
     * Returns the owner that gets the robot back when a loan ends.
     *
     * @return the owner of a robot that is lent; null if it is not lent, or has no owner
     */
    public @Nullable Owner lender() {
        return ownership.lender();
    }

    /**
     * Returns whether the robot has no work and no pending stop.
     *
     * @return true when the queue is empty, no command or stop is running, and the robot is not lent
     */
    public boolean isIdle() {
        return isIdle(null);
    }

    /**
     * Returns whether the robot has completed all commands of one source.
     *
     * @param by the source of the commands; differs from {@link #isIdle()} only for the borrower
     * @return true when no command from this source, and no stop, is running
     */
    public boolean isIdle(@Nullable Owner by) {
        return ownership.isIdle(by);
    }

    /**
     * Returns whether a stop of the robot is pending.
     *
     * @return true until the stop was sent to the robot and confirmed by it
     */
    public boolean isStopping() {
        return ownership.isStopping();
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
     * Returns whether STOP of the team is latched.
     *
     * @return true until it is released; the robot must not move until then
     */
    public boolean isStopLatched() {
        return ownership.isStopLatched();
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
    public boolean hasRoom(@Nullable Owner by) {
        return ownership.hasRoom(by);
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
        ownership.check(moves, by);
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
        ownership.submit(command, by);
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
            command.accept(ownership.controlFor(null));
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
            ownership.queue().runBeside(command);
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
        ownership.claim(newOwner);
        events.publish(listener -> listener.ownerChanged(this));
    }

    /**
     * Gives the robot back.
     *
     * @param oldOwner the previous owner; has no effect if the robot has another owner by now
     */
    public void free(Owner oldOwner) {
        if (ownership.free(oldOwner)) {
            publishGivenBack();
        }
    }

    private void publishGivenBack() {
        events.changes().raise();
        events.publish(listener -> listener.ownerChanged(this));
    }

    /**
     * Lends the robot: until {@link #takeBack} only the borrower's commands run, and those of the owner wait.
     *
     * @param to the borrower
     * @param permit the permit under which the borrower's commands run; a stop revokes it
     * @param by the owner, which remains the owner; null if there is none
     * @throws BotException if it has another owner, or is lent already, or a stop is pending, or it still runs a
     *     command other than the one that lends it
     */
    public void lend(Owner to, Permit permit, @Nullable Owner by) {
        ownership.lend(to, permit, by);
        events.publish(listener -> listener.ownerChanged(this));
    }

    /**
     * Ends a loan. Commands still queued under it are not run and not answered. A running command ends with the permit:
     * revoke the permit, and halt the robot, before this call. Waits for that command for at most
     * {@value #LAST_COMMAND_S} s, so that nothing it sends reaches a robot that has been given back.
     *
     * @param from the borrower; has no effect if the robot is not lent to it
     */
    public void takeBack(Owner from) {
        CommandQueue lent = ownership.closeLoan(from);
        if (lent == null) {
            return;
        }
        try {
            events.changes().await(lent::isAtRest, LAST_COMMAND_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (ownership.takeBack(from)) {
            publishGivenBack();
        }
    }

    /**
     * Publishes a status message of the holder of the robot.
     *
     * @param from the holder
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
        Owner borrower = ownership.revokeLoan(() -> new LinkLost(reason));
        if (borrower != null) {
            bot.time().runAsync("ending " + borrower.name(), borrower::endLoggingErrors);
        }
    }

    /** As a stop by a user of this program, except that it has been sent already. */
    @Override
    public void stoppedElsewhere() {
        Ownership.Stopped stopped = beginStop(null);
        events.changes().raise();
        bot.time().runAsync("ending what moved robot " + number, () -> {
            stopped.ended().forEach(Owner::endLoggingErrors);
            stopped.answer();
            endStop();
            endStop();
        });
    }

    void start() {
        ownership.queue().start("robot " + number + " worker");
    }

    /** Revokes permits and empties the queues; see {@link Ownership#beginStop}. Notifies nothing itself. */
    Ownership.Stopped beginStop(@Nullable Owner by) {
        return ownership.beginStop(by);
    }

    /** Ends one of the two parts of a stop; after both, commands run again. */
    void endStop() {
        ownership.endStop();
        events.changes().raise();
    }

    /** Allows motion again, unless another STOP came meanwhile. */
    void release() {
        ownership.release();
    }

    /** Closes the robot, then answers the queued commands, which are not run. */
    void close() {
        List<QueuedCommand> notRun = ownership.remove();
        try {
            bot.close();
        } finally {
            ownership.queue().answerNotRun(notRun, "robot " + number + " was removed");
        }
    }
}

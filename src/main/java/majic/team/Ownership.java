package majic.team;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.driver.BotDriver;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import org.jspecify.annotations.Nullable;

/**
 * Decides which source may command one robot: its owner, or the borrower to which the owner lends it. Each has a queue
 * and a permit. A stop revokes the permits, empties the queues and holds both back until it has ended. Thread-safe;
 * calls no listener, and waits for nothing.
 */
final class Ownership {
    private final int robot;
    private final BotDriver bot;
    private final TeamEvents events;
    private final BooleanSupplier stopIsLatched;
    private final PermittedControl control;
    private final CommandQueue queue;
    private @Nullable Owner owner;
    private long ownedSinceNanos;
    private @Nullable Loan loan;
    private int pendingStops;
    private boolean removed;

    /** A robot that its owner has lent: the borrower, what revokes the loan, and how the borrower's commands run. */
    private record Loan(Owner borrower, long sinceNanos, Permit permit, PermittedControl control, CommandQueue queue) {}

    /**
     * The consequences of a stop, to be announced once the stop has been written to every connection and no lock is
     * held.
     *
     * @param notRun the commands that were removed from each queue
     * @param ended the owners to end
     */
    record Stopped(Map<CommandQueue, List<QueuedCommand>> notRun, List<Owner> ended) {
        void answer() {
            notRun.forEach(CommandQueue::answerStopped);
        }
    }

    /**
     * Creates the state of a robot without an owner.
     *
     * @param robot the robot's number
     * @param stopIsLatched whether STOP is latched
     */
    Ownership(int robot, BotDriver bot, TeamEvents events, BooleanSupplier stopIsLatched) {
        this.robot = robot;
        this.bot = bot;
        this.events = events;
        this.stopIsLatched = stopIsLatched;
        this.control = new PermittedControl(bot, new Permit());
        this.queue = new CommandQueue(robot, bot.time(), events, this, () -> mayWork(null));
    }

    /** The queue of all commands but the borrower's. */
    CommandQueue queue() {
        return queue;
    }

    /** The borrower, otherwise the owner; null if there is neither. */
    synchronized @Nullable Owner holder() {
        return loan != null ? loan.borrower : owner;
    }

    /** Since when {@link #holder} has had the robot, on the robot's clock; of no meaning while there is none. */
    synchronized long heldSinceNanos() {
        return loan != null ? loan.sinceNanos : ownedSinceNanos;
    }

    /** The owner of a robot that is lent; null if it is not lent, or has no owner. */
    synchronized @Nullable Owner lender() {
        return loan != null ? owner : null;
    }

    /** Whether a source has no command left, and no stop is pending; the robot is not lent, except to this source. */
    synchronized boolean isIdle(@Nullable Owner by) {
        return (loan == null || isBorrower(by)) && queueOf(by).isIdle() && !isStopping();
    }

    synchronized boolean isStopping() {
        return pendingStops > 0;
    }

    boolean isStopLatched() {
        return stopIsLatched.getAsBoolean();
    }

    synchronized boolean hasRoom(@Nullable Owner by) {
        return queueOf(by).hasRoom();
    }

    private boolean isBorrower(@Nullable Owner by) {
        return by != null && loan != null && loan.borrower == by;
    }

    private CommandQueue queueOf(@Nullable Owner by) {
        return loan != null && isBorrower(by) ? loan.queue : queue;
    }

    private List<CommandQueue> queues() {
        return loan == null ? List.of(queue) : List.of(queue, loan.queue);
    }

    /** Whether the next command may begin. A borrower that is ending begins none; what it had queued is dropped. */
    private synchronized boolean mayWork(@Nullable Owner by) {
        return !isStopping() && (loan == null || (isBorrower(by) && !loan.permit.isRevoked()));
    }

    /** Returns how a command that is queued now uses the robot: the next stop, or losing the connection, ends it. */
    synchronized BotControl controlFor(@Nullable Owner by) {
        return (loan != null && isBorrower(by) ? loan.control : control).forCommand();
    }

    /**
     * Makes the checks of {@link #submit}.
     *
     * @throws BotException what {@link #submit} would throw now
     */
    synchronized void check(boolean moves, @Nullable Owner by) {
        if (removed) {
            throw new BotException(robot + ": robot " + robot + " was removed");
        }
        if (moves) {
            bot.permit().check();
            checkOwner(by);
        }
        if (!hasRoom(by)) {
            throw new BotException(robot + ": its queue is full (" + CommandQueue.DEPTH + " commands); wait, or \""
                    + robot + " stop\" empties it");
        }
    }

    /**
     * Returns normally only if this source may move the robot now. The owner's own commands wait for their turn while
     * the robot is lent; those of all others are refused.
     *
     * @throws BotException if the robot has another owner
     * @throws MotionStopped if the source was ended or has given the robot back, and may not have been notified yet
     */
    private void checkOwner(@Nullable Owner by) {
        refuseOthers(by);
        boolean isHolder = by == null || owner == by || isBorrower(by);
        if (!isHolder || (by != null && by.isDismissed())) {
            throw new MotionStopped("stopped");
        }
    }

    private void refuseOthers(@Nullable Owner by) {
        if (isBorrower(by)) {
            return;
        }
        Owner other = owner == null || owner != by ? holder() : null;
        if (other != null) {
            throw other.refusal(robot);
        }
    }

    /** Puts a command at the end of its source's queue; throws as {@link Member#submit}. */
    void submit(QueuedCommand command, @Nullable Owner by) {
        CommandQueue used;
        synchronized (this) {
            check(command.moves(), by);
            command.accept(controlFor(by));
            used = queueOf(by);
            used.add(command);
        }
        used.wake();
    }

    /**
     * Sets the owner.
     *
     * @throws BotException if the robot has another owner
     */
    synchronized void claim(Owner newOwner) {
        refuseOthers(newOwner);
        if (owner != newOwner) {
            owner = newOwner;
            ownedSinceNanos = bot.time().nanos();
        }
    }

    /** Removes the owner; false if the robot is not owned by it. */
    synchronized boolean free(Owner oldOwner) {
        boolean isOwner = owner == oldOwner;
        if (isOwner) {
            owner = null;
        }
        return isOwner;
    }

    /** Begins a loan; throws as {@link Member#lend}. */
    void lend(Owner to, Permit permit, @Nullable Owner by) {
        Loan begun = new Loan(
                to,
                bot.time().nanos(),
                permit,
                new PermittedControl(bot, permit),
                new CommandQueue(robot, bot.time(), events, this, () -> mayWork(to)));
        synchronized (this) {
            Owner holder = holder();
            if (holder == by && (isStopping() || !queue.isAtRest())) {
                throw new BotException(robot + " is still busy; \"" + robot + " wait\" lets it finish first");
            }
            if (holder != null && (holder != by || loan != null)) {
                throw holder.refusal(robot);
            }
            loan = begun;
        }
        begun.queue.start("robot " + robot + " " + to.name());
    }

    /**
     * Closes the queue of a loan; commands still in it are not run and not answered.
     *
     * @return the queue, in which a command may still run; null if the robot is not lent to this borrower
     */
    @Nullable
    CommandQueue closeLoan(Owner from) {
        CommandQueue lent;
        synchronized (this) {
            lent = loan != null && isBorrower(from) ? loan.queue : null;
        }
        if (lent != null) {
            lent.close();
            lent.drop().forEach(command -> command.end(new Answer(robot, Answer.Outcome.NOT_RUN, "")));
        }
        return lent;
    }

    /** Ends a loan; false if the robot is not lent to this borrower. */
    boolean takeBack(Owner from) {
        synchronized (this) {
            if (!isBorrower(from)) {
                return false;
            }
            loan = null;
        }
        queue.wake();
        return true;
    }

    /**
     * Revokes the permit of the loan, and with it the permit to move any robot that is lent under the same one.
     *
     * @return the borrower; null if the robot is not lent
     */
    synchronized @Nullable Owner revokeLoan(Supplier<? extends BotException> reason) {
        if (loan == null) {
            return null;
        }
        loan.permit.revoke(reason);
        return loan.borrower;
    }

    /**
     * Revokes permits and empties the queues. The stop is pending until {@link #endStop} was called twice: when the
     * robot was stopped, and when all listeners were notified. A stop by the borrower itself ends only the borrower's
     * own commands.
     *
     * @param by the source of the stop, which is not ended; null for a user
     */
    synchronized Stopped beginStop(@Nullable Owner by) {
        pendingStops += 2;
        boolean latched = stopIsLatched.getAsBoolean();
        if (loan != null && isBorrower(by) && !latched) {
            loan.control.endMotions();
            return new Stopped(Map.of(loan.queue, loan.queue.drop()), List.of());
        }
        if (latched) {
            bot.latch();
        } else {
            bot.revokeMotions();
        }
        List<Owner> ended = dismiss(by);
        Map<CommandQueue, List<QueuedCommand>> notRun = new LinkedHashMap<>();
        queues().forEach(each -> notRun.put(each, each.drop()));
        return new Stopped(notRun, ended);
    }

    /** Revokes the right of owner and borrower to move the robot, except for the source of the stop. */
    private List<Owner> dismiss(@Nullable Owner by) {
        if (!isBorrower(by)) {
            revokeLoan(() -> new MotionStopped("stopped"));
        }
        List<Owner> dismissed = Stream.of(loan == null ? null : loan.borrower, owner)
                .filter(Objects::nonNull)
                .filter(each -> each != by)
                .toList();
        dismissed.forEach(Owner::dismiss);
        return dismissed;
    }

    void endStop() {
        List<CommandQueue> all;
        synchronized (this) {
            pendingStops--;
            all = queues();
        }
        all.forEach(CommandQueue::wake);
    }

    /** Allows motion again, unless another STOP came meanwhile. */
    synchronized void release() {
        if (!stopIsLatched.getAsBoolean()) {
            bot.unlatch();
        }
    }

    /**
     * Accepts no further command and closes the queues.
     *
     * @return the commands of the robot's own queue that are not run
     */
    List<QueuedCommand> remove() {
        List<QueuedCommand> notRun;
        List<CommandQueue> all;
        synchronized (this) {
            removed = true;
            notRun = queue.drop();
            all = queues();
        }
        all.forEach(CommandQueue::close);
        return notRun;
    }
}

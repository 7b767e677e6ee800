package majic.team;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.driver.BotDriver;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import org.jspecify.annotations.Nullable;

/**
 * Which owner may move one robot: the one whose lease is the last. The first lease has no owner: users who type
 * commands share it, and it does not end. A script, manual control or another desk adds a lease with its owner, which
 * uses the same queue. An act adds a sublease, with a queue of its own, for which those below wait. A stop revokes the
 * owners, empties the queues and holds them back until it has ended. Thread-safe; calls no listener, and waits for
 * nothing.
 */
final class Leases {
    private final int robot;
    private final BotDriver bot;
    private final TeamEvents events;
    private final BooleanSupplier stopIsLatched;
    private final Lease users;
    private @Nullable Lease owned;
    private @Nullable Lease sublease;
    private int pendingStops;
    private boolean removed;

    /**
     * The use of the robot by an owner until it gives the robot back.
     *
     * @param owner null for users
     * @param control under which its commands run
     * @param queue in which they wait
     */
    private record Lease(@Nullable Owner owner, long sinceNanos, PermittedControl control, CommandQueue queue) {}

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
    Leases(int robot, BotDriver bot, TeamEvents events, BooleanSupplier stopIsLatched) {
        this.robot = robot;
        this.bot = bot;
        this.events = events;
        this.stopIsLatched = stopIsLatched;
        this.users = lease(null, new Permit());
    }

    /** A lease with a control and a queue of its own, whose thread is not started. */
    private Lease lease(@Nullable Owner owner, Permit permit) {
        return new Lease(
                owner,
                bot.time().nanos(),
                new PermittedControl(bot, permit),
                new CommandQueue(robot, bot.time(), events, this, () -> mayWork(owner)));
    }

    /** The queue of all commands but those of a sublease. */
    CommandQueue queue() {
        return users.queue;
    }

    private Lease last() {
        if (sublease != null) {
            return sublease;
        }
        return owned != null ? owned : users;
    }

    /** The lease of a source; that of users if it has none. */
    private Lease of(@Nullable Owner by) {
        if (by != null && sublease != null && sublease.owner == by) {
            return sublease;
        }
        return by != null && owned != null && owned.owner == by ? owned : users;
    }

    /** The owner of the last lease; null if only users have the robot. */
    synchronized @Nullable Owner owner() {
        return last().owner;
    }

    /** Since when {@link #owner} has had the robot, on the robot's clock; of no meaning while there is none. */
    synchronized long ownedSinceNanos() {
        return last().sinceNanos;
    }

    /** The owner that gets the robot back when a sublease ends; null if there is no sublease, or no such owner. */
    synchronized @Nullable Owner sublessor() {
        return sublease != null && owned != null ? owned.owner : null;
    }

    /** Whether a source has no command left, and no stop is pending; no sublease is in its way. */
    synchronized boolean isIdle(@Nullable Owner by) {
        CommandQueue queue = of(by).queue;
        return pendingStops == 0 && queue == last().queue && queue.isIdle();
    }

    synchronized boolean isStopping() {
        return pendingStops > 0;
    }

    boolean isStopLatched() {
        return stopIsLatched.getAsBoolean();
    }

    synchronized boolean hasRoom(@Nullable Owner by) {
        return of(by).queue.hasRoom();
    }

    /** Whether the next command may begin; an act whose owner was revoked begins none. */
    private synchronized boolean mayWork(@Nullable Owner by) {
        return pendingStops == 0 && (sublease == null || (sublease.owner == by && by != null && !by.isRevoked()));
    }

    private List<CommandQueue> queues() {
        return sublease == null ? List.of(users.queue) : List.of(users.queue, sublease.queue);
    }

    /** Returns how a command that is queued now uses the robot: the next stop, or losing the connection, ends it. */
    synchronized BotControl controlFor(@Nullable Owner by) {
        return of(by).control.forCommand();
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
        if (!of(by).queue.hasRoom()) {
            throw new BotException(robot + ": its queue is full (" + CommandQueue.DEPTH + " commands); wait, or \""
                    + robot + " stop\" empties it");
        }
    }

    /**
     * Returns normally only if this source may move the robot now. The commands of an owner wait for their turn behind
     * a sublease; those of all others are refused.
     *
     * @throws BotException if the robot has another owner
     * @throws MotionStopped if the source was revoked or has given the robot back, and may not have been notified yet
     */
    private void checkOwner(@Nullable Owner by) {
        refuseOthers(by);
        if (by != null && (of(by) == users || by.isRevoked())) {
            throw new MotionStopped("stopped");
        }
    }

    private void refuseOthers(@Nullable Owner by) {
        Owner other = of(by) == users ? last().owner : null;
        if (other != null) {
            throw other.refusal(robot);
        }
    }

    /** Puts a command at the end of its source's queue; throws as {@link Member#submit}. */
    void submit(QueuedCommand command, @Nullable Owner by) {
        CommandQueue used;
        synchronized (this) {
            check(command.moves(), by);
            Lease lease = of(by);
            command.accept(lease.control.forCommand());
            used = lease.queue;
            used.add(command);
        }
        used.wake();
    }

    /**
     * Adds a lease that uses the queue of users, unless the owner has one already.
     *
     * @throws BotException if the robot has another owner
     */
    synchronized void claim(Owner by) {
        refuseOthers(by);
        if (of(by) == users) {
            owned = new Lease(by, bot.time().nanos(), users.control, users.queue);
        }
    }

    /** Ends the lease of an owner; false if it has none. A sublease goes on. */
    synchronized boolean free(Owner by) {
        boolean isOwner = owned != null && owned.owner == by;
        if (isOwner) {
            owned = null;
        }
        return isOwner;
    }

    /** Adds a sublease; throws as {@link Member#sublet}. */
    void sublet(Owner to, @Nullable Owner by) {
        Lease begun = lease(to, to.permit());
        synchronized (this) {
            Owner owner = last().owner;
            if (owner == by && (isStopping() || !users.queue.isAtRest())) {
                throw new BotException(robot + " is still busy; \"" + robot + " wait\" lets it finish first");
            }
            if (owner != null && (owner != by || sublease != null)) {
                throw owner.refusal(robot);
            }
            sublease = begun;
        }
        begun.queue.start("robot " + robot + " " + to.name());
    }

    /**
     * Closes the queue of a sublease; commands still in it are not run and not answered.
     *
     * @return the queue, in which a command may still run; null if this owner has no sublease
     */
    @Nullable
    CommandQueue closeSublease(Owner of) {
        CommandQueue closed;
        synchronized (this) {
            if (sublease == null || sublease.owner != of) {
                return null;
            }
            closed = sublease.queue;
        }
        closed.close();
        closed.drop().forEach(command -> command.end(new Answer(robot, Answer.Outcome.NOT_RUN, "")));
        return closed;
    }

    /** Ends a sublease; false if this owner has none. */
    boolean endSublease(Owner of) {
        synchronized (this) {
            if (sublease == null || sublease.owner != of) {
                return false;
            }
            sublease = null;
        }
        users.queue.wake();
        return true;
    }

    /**
     * Revokes the owner of the sublease, on all robots that it has.
     *
     * @return that owner; null if there is no sublease
     */
    synchronized @Nullable Owner revokeSublease(Supplier<? extends BotException> reason) {
        Owner owner = sublease == null ? null : sublease.owner;
        if (owner != null) {
            owner.permit().revoke(reason);
        }
        return owner;
    }

    /**
     * Revokes permits and empties the queues. The stop is pending until {@link #endStop} was called twice: when the
     * robot was stopped, and when all listeners were notified. A stop by the owner of the sublease itself ends only its
     * own commands.
     *
     * @param by the source of the stop, which is not revoked; null for a user
     */
    synchronized Stopped beginStop(@Nullable Owner by) {
        pendingStops += 2;
        boolean latched = stopIsLatched.getAsBoolean();
        if (by != null && sublease != null && sublease.owner == by && !latched) {
            sublease.control.endMotions();
            return new Stopped(Map.of(sublease.queue, sublease.queue.drop()), List.of());
        }
        if (latched) {
            bot.latch();
        } else {
            bot.revokeMotions();
        }
        List<Owner> ended = revokeAllBut(by);
        Map<CommandQueue, List<QueuedCommand>> notRun = new LinkedHashMap<>();
        queues().forEach(each -> notRun.put(each, each.drop()));
        return new Stopped(notRun, ended);
    }

    private List<Owner> revokeAllBut(@Nullable Owner by) {
        List<Owner> revoked = new ArrayList<>();
        for (Lease lease : new Lease[] {sublease, owned}) {
            if (lease != null && lease.owner != by) {
                revoked.add(Objects.requireNonNull(lease.owner));
            }
        }
        revoked.forEach(owner -> owner.permit().revoke(() -> new MotionStopped("stopped")));
        return revoked;
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
            notRun = users.queue.drop();
            all = queues();
        }
        all.forEach(CommandQueue::close);
        return notRun;
    }
}

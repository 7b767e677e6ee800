package majic.shared.desk;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.driver.BotDriver;
import majic.driver.PermittedControl;
import majic.shared.message.Sender;
import majic.team.Member;
import majic.team.Owner;
import majic.time.TimeSource;

/**
 * The permission of a program at another desk to move one robot, until it is given back, stopped, or no longer
 * confirmed by heartbeats. Ends once. Thread-safe.
 */
final class RobotHold {
    /** Without a valid heartbeat for longer than this the robot is halted, seconds. */
    static final double HEARTBEAT_S = 1;

    /** A hold that began with a motion ends this long after the last one, seconds. */
    private static final double UNUSED_S = 5;

    private final Member member;
    private final Sender holder;
    private final TimeSource time;
    private final Owner owner;
    private final BiConsumer<RobotHold, Boolean> whenEnded;
    private final AtomicBoolean ended = new AtomicBoolean();
    private final AtomicInteger open = new AtomicInteger();
    private volatile boolean explicit;
    private volatile PermittedControl control;
    private volatile long beatNanos;
    private volatile long usedNanos;

    /**
     * Creates the hold of a robot; {@link #begin} claims the robot.
     *
     * @param time the clock of the desk
     * @param whenEnded called once when it has ended, with true if it was taken from the holder; on the thread that
     *     ends it, must not wait
     */
    RobotHold(Member member, Sender holder, TimeSource time, BiConsumer<RobotHold, Boolean> whenEnded) {
        this.member = member;
        this.holder = holder;
        this.time = time;
        this.whenEnded = whenEnded;
        this.owner = new Owner(Owner.Kind.REMOTE, holder.toString(), this::taken);
        this.control = newControl();
    }

    /**
     * Claims the robot.
     *
     * @throws BotException if it has another owner, commands of others, or STOP is latched
     */
    void begin() {
        member.check(true, null);
        if (!member.isIdle()) {
            throw new BotException(member.number() + " is busy with commands of its own desk");
        }
        control = newControl();
        beat();
        use();
        member.claim(owner);
    }

    /** A stop of the robot, or the loss of its connection, ends the use of a control for good. */
    private PermittedControl newControl() {
        return new PermittedControl(BotDriver.of(member.bot()), owner.permit()).forCommand();
    }

    Sender holder() {
        return holder;
    }

    boolean isOf(Sender sender) {
        return holder.session().equals(sender.session());
    }

    Owner owner() {
        return owner;
    }

    Member member() {
        return member;
    }

    /** Drives the robot at once; a stop that came since the last {@link #stopped()} is in the way. */
    BotControl control() {
        return control;
    }

    /** Makes it last until it is given back, not only as long as it is used. */
    void keep() {
        explicit = true;
    }

    boolean isKept() {
        return explicit;
    }

    void beat() {
        beatNanos = time.nanos();
    }

    /** Notes that the robot was just used. */
    void use() {
        usedNanos = time.nanos();
    }

    void began() {
        open.incrementAndGet();
    }

    void completed() {
        use();
        open.decrementAndGet();
    }

    /** The holder's own stop was sent to the robot: what the holder sends from now on may move it. */
    void stopped() {
        control = newControl();
    }

    /** Seconds until the heartbeat is overdue; zero or less if it is. */
    double heartbeatLeftS() {
        return HEARTBEAT_S - time.secondsSince(beatNanos);
    }

    /** Whether it began with a motion, and there was none for a while. */
    boolean isUnused() {
        return !explicit && open.get() == 0 && time.secondsSince(usedNanos) >= UNUSED_S;
    }

    boolean hasEnded() {
        return ended.get();
    }

    /** Revokes the right to drive at once, without stopping or freeing the robot; does not block. */
    void revoke() {
        owner.permit().revoke(() -> new MotionStopped("the robot is no longer held"));
    }

    /** Whether it is about to end. */
    boolean isRevoked() {
        return owner.isRevoked();
    }

    /** Gives the robot back; sends nothing to it. */
    void end() {
        end(false);
    }

    /** Takes the robot from its holder: after a stop by others, or a fault. */
    void taken() {
        end(true);
    }

    private void end(boolean isTaken) {
        revoke();
        if (ended.compareAndSet(false, true)) {
            whenEnded.accept(this, isTaken);
            member.free(owner);
        }
    }
}

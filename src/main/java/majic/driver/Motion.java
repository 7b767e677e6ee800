package majic.driver;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * One motion in progress, as its driver handles it. Every command that moves the robot is sent through it and every
 * wait is done through it, so a stop, a lost link or the guard ends the motion wherever it is. Used by one thread.
 */
public final class Motion {
    /** How often what ends a motion is looked for at least, seconds. */
    private static final double LOOK_S = 0.05;

    private final MovingRobot bot;
    private final MotionGate gate;
    private final Guard guard;
    private final Permit permit;
    private final TimeSource time;
    private final long startedNanos;
    private long partNanos;
    private long readingsSeen = -1;
    private boolean guardReached;
    private boolean guardHandedOver;
    private boolean hasSent;
    private @Nullable Supplier<@Nullable String> ending;
    private @Nullable String endedBecause;

    Motion(MovingRobot bot, MotionGate gate, Guard guard, Permit permit) {
        this.bot = bot;
        this.gate = gate;
        this.guard = guard;
        this.permit = permit;
        this.time = bot.time();
        this.startedNanos = time.nanos();
        this.partNanos = startedNanos;
    }

    /**
     * Sends something that moves the robot. No stop can come between the check of the permit and the sending.
     *
     * @param write does the sending; at most one message, bounded by the link's deadline
     * @throws MotionStopped if the motion was stopped; nothing was sent
     * @throws LinkLost if the connection is gone
     */
    public void send(Runnable write) {
        gate.send(permit, () -> {
            hasSent = true;
            write.run();
        });
    }

    /** Returns whether anything was sent, so that the robot may move by it. */
    boolean hasSent() {
        return hasSent;
    }

    /**
     * Waits until a condition is true, the guard becomes true, or the time is over.
     *
     * @param done what to wait for; checked whenever the driver raises {@link BotDriver#changes()}
     * @param seconds how long at most
     * @return whether the condition became true; if not, {@link #guardReached()} gives the reason
     * @throws MotionStopped if the motion was stopped meanwhile
     * @throws LinkLost if the connection broke meanwhile
     * @throws MotionFailed if the guard cannot be evaluated
     */
    public boolean await(BooleanSupplier done, double seconds) {
        long deadlineNanos = time.nanos() + (long) Math.ceil(seconds * 1e9);
        while (true) {
            check();
            if (done.getAsBoolean()) {
                return true;
            }
            long leftNanos = deadlineNanos - time.nanos();
            if (lookAtGuard() || lookAtEnding() || leftNanos <= 0) {
                return false;
            }
            double leftS = leftNanos / 1e9;
            pause(done, ending == null ? leftS : Math.min(LOOK_S, leftS));
        }
    }

    /**
     * Waits for a time.
     *
     * @param seconds how long
     * @return whether the time passed; false when the guard came true before
     * @throws MotionStopped if the motion was stopped meanwhile
     * @throws LinkLost if the connection broke meanwhile
     * @throws MotionFailed if the guard cannot be evaluated
     */
    public boolean pause(double seconds) {
        await(() -> false, seconds);
        return !guardReached;
    }

    /** Sends a notice to the user in the robot's name. */
    public void notice(String message) {
        bot.notice(message);
    }

    /**
     * Returns whether the guard ended the motion.
     *
     * @return true from the moment it was seen to be reached
     */
    public boolean guardReached() {
        return guardReached;
    }

    /**
     * Returns whether something may end the motion before its time.
     *
     * @return false for a motion without {@code until} that goes on whatever is in its way
     */
    public boolean isGuarded() {
        return guard != Guard.NEVER || ending != null;
    }

    /**
     * Ends the motion, as its guard would, when there is a reason, which makes it fail.
     *
     * @param reason asked every 50 ms; null to go on
     */
    void endWhen(Supplier<@Nullable String> reason) {
        ending = reason;
    }

    /** Returns the reason that has ended the motion; null if none has. */
    @Nullable
    String endedBecause() {
        return endedBecause;
    }

    /**
     * Hands the guard over to a program next to the robot, which ends the motion when it becomes true. This motion does
     * not evaluate it any more.
     *
     * @param accepted whether that program can evaluate a condition in MAJIC Script
     * @return the condition; empty if there is no guard, or it cannot be handed over: this motion then goes on to
     *     evaluate it
     */
    public Optional<String> handOverGuard(Predicate<String> accepted) {
        Optional<String> text = guard.text().filter(accepted);
        guardHandedOver = text.isPresent();
        return text;
    }

    /**
     * Returns the time since the motion began, or its present part: a turn of a motion by a course is a part.
     *
     * @return seconds on the robot's clock
     */
    public double seconds() {
        return time.secondsSince(partNanos);
    }

    /** Returns the time since the whole motion began, s. */
    double wholeSeconds() {
        return time.secondsSince(startedNanos);
    }

    /**
     * Makes a part of the motion, for which a driver measures its own time.
     *
     * @param maneuver the part
     * @param isBlocked ends this part, and not the motion
     */
    void part(Runnable maneuver, BooleanSupplier isBlocked) {
        partNanos = time.nanos();
        ending = () -> isBlocked.getAsBoolean() ? "" : null;
        maneuver.run();
        ending = null;
        if (endedBecause != null) {
            endedBecause = null;
            guardReached = false;
        }
    }

    /**
     * Goes on only while nothing has ended the motion.
     *
     * @throws MotionStopped if it was stopped
     * @throws LinkLost if the connection broke
     */
    public void check() {
        permit.check();
        bot.requireConnected();
    }

    /**
     * Checks the guard, if there is one and there are new readings. The first check, when nothing moves yet, may wait
     * for answers of robots.
     */
    private boolean lookAtGuard() {
        long readings = bot.readings().count();
        if (watchesGuard() && !guardReached && readings != readingsSeen) {
            boolean first = readingsSeen < 0;
            readingsSeen = readings;
            try {
                guardReached = first ? guard.reached() : WaitPolicy.without(guard::reached);
            } catch (MotionStopped e) {
                throw e;
            } catch (BotException e) {
                // A guard may read other robots: a connection lost there does not concern this robot.
                check();
                throw new MotionFailed(e.getMessage());
            }
        }
        return guardReached;
    }

    private boolean watchesGuard() {
        return guard != Guard.NEVER && !guardHandedOver;
    }

    private boolean lookAtEnding() {
        if (ending != null && !guardReached) {
            endedBecause = ending.get();
            guardReached = endedBecause != null;
        }
        return guardReached;
    }

    private void pause(BooleanSupplier done, double seconds) {
        long seen = readingsSeen;
        try {
            bot.changes()
                    .await(
                            () -> done.getAsBoolean()
                                    || permit.isRevoked()
                                    || !bot.isConnected()
                                    || (watchesGuard() && bot.readings().count() != seen),
                            seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }
}

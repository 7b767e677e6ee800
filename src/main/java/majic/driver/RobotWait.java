package majic.driver;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * Waits, on the clock of a robot, for conditions that its reader or timer thread makes true. The three methods differ
 * in what an interruption of the waiting thread does; its interrupt flag stays set. Thread-safe.
 *
 * @param time the robot's clock
 * @param changes raised when such a condition may have become true
 */
public record RobotWait(TimeSource time, Signal changes) {
    /**
     * Waits for a robot that is connected. An interruption is a stop.
     *
     * @param condition quick and without side effects; tested at once and after each change
     * @param seconds the longest wait
     * @return whether the condition holds
     * @throws MotionStopped if the thread is interrupted
     */
    public boolean await(BooleanSupplier condition, double seconds) {
        try {
            return changes.await(condition, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }

    /**
     * Waits on the thread that connects a robot. An interruption ends the attempt.
     *
     * @param condition as in {@link #await}
     * @param seconds the longest wait
     * @return whether the condition holds
     * @throws BotException if the thread is interrupted
     */
    public boolean awaitConnecting(BooleanSupplier condition, double seconds) {
        try {
            return changes.await(condition, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted while connecting", e);
        }
    }

    /**
     * Waits on a thread that stops or closes a robot. An interruption ends the wait, and nothing is thrown, so that the
     * rest of the closing is done.
     *
     * @param condition as in {@link #await}
     * @param seconds the longest wait
     * @return whether the condition holds
     */
    public boolean awaitClosing(BooleanSupplier condition, double seconds) {
        try {
            return changes.await(condition, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return condition.getAsBoolean();
        }
    }
}

package majic.aibo.urbi;

import java.util.function.BooleanSupplier;
import majic.bot.MotionStopped;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * Waits for changes, and measures time, by the robot's clock.
 *
 * @param time the robot's clock
 * @param changes raised when a message came from the dog that a thread may wait for
 */
public record Waiting(TimeSource time, Signal changes) {

    /** Waits until a condition holds, for some seconds at most; returns whether it holds. An interruption is a stop. */
    public boolean await(BooleanSupplier done, double seconds) {
        try {
            return changes.await(done, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }
}

package majic.aibo.urbi;

import java.util.function.BooleanSupplier;
import majic.bot.MotionStopped;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * Where the driver's parts wait and what they measure by.
 *
 * @param time the robot's clock
 * @param changes raised whenever something came from the dog that somebody may wait for
 */
public record Waiting(TimeSource time, Signal changes) {

    /** Waits until something is so, for some seconds at most; tells whether it is. An interruption is a stop. */
    public boolean await(BooleanSupplier done, double seconds) {
        try {
            return changes.await(done, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }
}

package majic.pioneer.session;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.driver.RobotWait;

/**
 * Waits of the thread that connects; they end as soon as the connection attempt is canceled.
 *
 * @param waiting woken when a condition may have changed, and at cancellation
 * @param canceled whether the connection attempt is canceled
 */
public record ConnectWait(RobotWait waiting, BooleanSupplier canceled) {
    /**
     * Waits until a condition holds.
     *
     * @return whether it held in time
     * @throws BotException if the attempt is canceled, or the thread is interrupted
     */
    public boolean await(BooleanSupplier condition, double seconds) {
        waiting.awaitConnecting(() -> condition.getAsBoolean() || canceled.getAsBoolean(), seconds);
        if (canceled.getAsBoolean()) {
            throw new BotException("closed while connecting");
        }
        return condition.getAsBoolean();
    }

    /** Wakes the waiting thread to test its condition again. */
    public void raise() {
        waiting.changes().raise();
    }
}

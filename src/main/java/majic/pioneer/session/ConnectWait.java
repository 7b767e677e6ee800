package majic.pioneer.session;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.time.Signal;

/** Waits of the thread that connects; they end as soon as the connection attempt is canceled. */
final class ConnectWait {
    private final Signal changes;
    private final BooleanSupplier canceled;

    /**
     * Creates the waits of one session.
     *
     * @param changes raised when a condition may have changed, and at cancellation
     * @param canceled whether the connection attempt is canceled
     */
    ConnectWait(Signal changes, BooleanSupplier canceled) {
        this.changes = changes;
        this.canceled = canceled;
    }

    /**
     * Waits until a condition holds.
     *
     * @return whether it held in time
     * @throws BotException if the attempt is canceled, or the thread is interrupted
     */
    boolean await(BooleanSupplier condition, double seconds) {
        try {
            changes.await(() -> condition.getAsBoolean() || canceled.getAsBoolean(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted while connecting", e);
        }
        if (canceled.getAsBoolean()) {
            throw new BotException("closed while connecting");
        }
        return condition.getAsBoolean();
    }

    /** Wakes the waiting thread to test its condition again. */
    void raise() {
        changes.raise();
    }
}

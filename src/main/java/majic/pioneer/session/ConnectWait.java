package majic.pioneer.session;

import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.time.Signal;

/** Waits of the thread that connects: they end as soon as nobody wants the connection any more. */
final class ConnectWait {
    private final Signal changes;
    private final BooleanSupplier givenUp;

    /**
     * For one session.
     *
     * @param changes raised by whoever makes something so, or gives up
     * @param givenUp whether nobody wants the connection any more
     */
    ConnectWait(Signal changes, BooleanSupplier givenUp) {
        this.changes = changes;
        this.givenUp = givenUp;
    }

    /**
     * Waits.
     *
     * @return whether it came to be so in time
     * @throws BotException if the connection is not wanted any more, or the thread is interrupted
     */
    boolean await(BooleanSupplier condition, double seconds) {
        try {
            changes.await(() -> condition.getAsBoolean() || givenUp.getAsBoolean(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted while connecting", e);
        }
        if (givenUp.getAsBoolean()) {
            throw new BotException("closed while connecting");
        }
        return condition.getAsBoolean();
    }

    /** Makes whoever waits look again. */
    void raise() {
        changes.raise();
    }
}

package majic.time;

import java.util.function.BooleanSupplier;

/** A signal that knows whether the thread that waits last would go on if it were woken now. */
public final class LastWait implements Signal {
    private final Signal signal;
    private volatile BooleanSupplier condition = () -> false;

    /** Waits and wakes as another signal does. */
    public LastWait(Signal signal) {
        this.signal = signal;
    }

    /** Whether the condition of the last wait holds. */
    public boolean isOver() {
        return condition.getAsBoolean();
    }

    @Override
    public boolean await(BooleanSupplier awaited, double seconds) throws InterruptedException {
        condition = awaited;
        return signal.await(awaited, seconds);
    }

    @Override
    public void raise() {
        signal.raise();
    }
}

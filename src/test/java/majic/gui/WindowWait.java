package majic.gui;

import java.util.function.BooleanSupplier;
import org.assertj.swing.timing.Condition;
import org.assertj.swing.timing.Pause;
import org.assertj.swing.timing.Timeout;

/** Waits for the content of a window. */
public final class WindowWait {
    /** Long, since a busy computer is slow; a wait that is over ends at once. */
    private static final long PATIENCE_MS = 60_000;

    private WindowWait() {}

    /**
     * Waits for something to become true, and fails if it does not.
     *
     * @param what names it in the failure
     * @param condition evaluated repeatedly, on the calling thread
     */
    public static void await(String what, BooleanSupplier condition) {
        Pause.pause(
                new Condition(what) {
                    @Override
                    public boolean test() {
                        return condition.getAsBoolean();
                    }
                },
                Timeout.timeout(PATIENCE_MS));
    }
}

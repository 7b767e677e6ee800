package majic.gui;

import java.util.function.BooleanSupplier;
import majic.time.WaitLimit;
import org.assertj.swing.timing.Condition;
import org.assertj.swing.timing.Pause;
import org.assertj.swing.timing.Timeout;

/** Waits for the content of a window. */
public final class WindowWait {
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
                Timeout.timeout(WaitLimit.MS));
    }
}

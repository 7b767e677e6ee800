package majic.pioneer.line;

import java.util.function.BooleanSupplier;
import majic.driver.RobotWait;
import majic.time.WaitPolicy;

/**
 * Counts the SIPs of one connection, and waits for more of them. Counted by the reader thread, awaited by any other.
 */
final class SipCounter {
    private final RobotWait waiting;
    private volatile int count;

    /**
     * Creates a counter.
     *
     * @param waiting woken after each SIP
     */
    SipCounter(RobotWait waiting) {
        this.waiting = waiting;
    }

    void add() {
        count = count + 1;
    }

    int count() {
        return count;
    }

    /** Waits until there have been more SIPs than a number; returns whether they came in time. */
    boolean awaitMoreThan(int number, double seconds) {
        return await(() -> count > number, seconds);
    }

    /** Waits until a condition holds; a thread that must not wait, or is interrupted, only tests it. */
    boolean await(BooleanSupplier condition, double seconds) {
        return waiting.awaitClosing(condition, WaitPolicy.isAllowed() ? seconds : 0);
    }
}

package majic.shared.desk;

import java.util.Locale;
import majic.bot.BotException;
import majic.time.TimeSource;

/**
 * The clock of a desk that shares robots, in milliseconds since the desk began. The sender of a motion states in this
 * clock until when it may begin, so the clocks of two computers are never compared. Thread-safe.
 */
final class DeskClock {
    /** More than any sender of this version asks for: a later time comes from another clock. */
    private static final long FARTHEST_MS = 5000;

    private final TimeSource time;
    private final long startNanos;

    DeskClock(TimeSource time) {
        this.time = time;
        this.startNanos = time.nanos();
    }

    long ms() {
        return (time.nanos() - startNanos) / 1_000_000;
    }

    /**
     * Refuses what arrives too late, or was not computed from this clock.
     *
     * @param validUntil ms of this clock
     * @throws BotException with the reason
     */
    void check(long validUntil) {
        long now = ms();
        if (validUntil > now + FARTHEST_MS) {
            throw new BotException("validUntil is " + validUntil + ", but the clock of this desk is at " + now
                    + "; add at most " + FARTHEST_MS + " to the \"clock\" of the last state");
        }
        if (now > validUntil) {
            throw new BotException(
                    String.format(Locale.ROOT, "came %.1f s too late; nothing was done", (now - validUntil) / 1000.0));
        }
    }

    /** Whether something may still begin; false for what {@link #check} refuses. */
    boolean isValid(long validUntil) {
        long now = ms();
        return now <= validUntil && validUntil <= now + FARTHEST_MS;
    }
}

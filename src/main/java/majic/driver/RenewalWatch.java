package majic.driver;

import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Finds that a velocity which is renewed all the time was not renewed for a while, because the program did not run: it
 * was suspended, or one of its threads was. A robot that its own watchdog has stopped meanwhile must not move again by
 * itself. For one motion or drive; used by one thread at a time.
 */
public final class RenewalWatch {
    /** A velocity that is renewed later than this ends its motion, seconds. */
    private static final double LATEST_S = 1.5;

    private final TimeSource time;
    private long renewedNanos;

    /** Begins to watch now. */
    public RenewalWatch(TimeSource time) {
        this.time = time;
        this.renewedNanos = time.nanos();
    }

    /** Takes note that the velocity is renewed. */
    public void renewed() {
        renewedNanos = time.nanos();
    }

    /** Returns, as half a sentence, that the velocity must not be renewed any more; null if it may. */
    public @Nullable String late() {
        return late(time.secondsSince(renewedNanos));
    }

    /**
     * Returns, as half a sentence, that a velocity must not be renewed any more.
     *
     * @param seconds since it was sent
     * @return null if it may be renewed
     */
    static @Nullable String late(double seconds) {
        return seconds > LATEST_S ? "this program stood still for " + Math.round(seconds) + " s" : null;
    }
}

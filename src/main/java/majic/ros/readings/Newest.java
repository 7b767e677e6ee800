package majic.ros.readings;

import java.util.Optional;
import majic.bot.Value;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The newest reading of one kind, with its age. A reading becomes unknown when the next one is overdue: after the given
 * time, or after twice the time between the last two, whichever is longer. Thread-safe.
 *
 * @param <T> the reading, immutable
 */
public final class Newest<T> {
    /** A lasting condition that is only reported when it changes does not age. */
    static final double NEVER = Double.POSITIVE_INFINITY;

    private static final double OVERDUE = 2;

    private final TimeSource time;
    private final double freshS;
    private volatile @Nullable Arrived<T> newest;
    private volatile boolean any;

    /** A reading with the time at which it was measured or arrived. */
    private record Arrived<T>(T reading, long atNanos, double intervalS) {}

    /**
     * No reading yet.
     *
     * @param freshS how long a reading is valid at least, s
     */
    Newest(TimeSource time, double freshS) {
        this.time = time;
        this.freshS = freshS;
    }

    void arrived(T reading) {
        measured(reading, time.nanos());
    }

    /** Takes a reading that was measured before it arrived. */
    void measured(T reading, long now) {
        Arrived<T> before = newest;
        any = true;
        newest = new Arrived<>(reading, now, before == null ? 0 : (now - before.atNanos()) / 1e9);
    }

    /** Forgets the reading: the connection was lost that it came on. */
    void lost() {
        newest = null;
    }

    /**
     * Returns the reading.
     *
     * @return empty without one, and if it is too old
     */
    public Optional<T> get() {
        Arrived<T> known = newest;
        return known == null || isOld(known) ? Optional.empty() : Optional.of(known.reading());
    }

    /**
     * Returns why there is no reading.
     *
     * @return an unknown value
     */
    public Value unknown() {
        return Value.unknown(any ? "no reading of late" : "no reading yet");
    }

    /**
     * Returns the age of the newest reading.
     *
     * @return s since it was measured, as far as that is known, or arrived; positive infinity without one
     */
    public double ageS() {
        Arrived<T> known = newest;
        return known == null ? Double.POSITIVE_INFINITY : time.secondsSince(known.atNanos());
    }

    /** A pause may have been an outage, so an interval counts only while it is not much longer than expected. */
    private boolean isOld(Arrived<T> known) {
        double limitS = Math.max(freshS, OVERDUE * Math.min(known.intervalS(), OVERDUE * freshS));
        return time.secondsSince(known.atNanos()) > limitS;
    }
}

package majic.driver;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.time.TimeSource;

/**
 * Records when something last happened to each of several things: when a value was read, requested or received. So a
 * driver polls a value only while something reads it. Thread-safe.
 *
 * @param <K> identifies a thing; compared with {@code equals}
 */
public final class LastTimes<K> {
    private final TimeSource time;
    private final Map<K, Long> nanos = new ConcurrentHashMap<>();

    /** Records nothing yet; times are on the given clock. */
    public LastTimes(TimeSource time) {
        this.time = time;
    }

    /** Records that it happens now. */
    public void record(K key) {
        nanos.put(key, time.nanos());
    }

    /** The time since it happened, seconds; infinite if it never did. */
    public double secondsSince(K key) {
        Long last = nanos.get(key);
        return last == null ? Double.POSITIVE_INFINITY : time.secondsSince(last);
    }

    /** All to which it happened within the last seconds; forgets the others. */
    public List<K> within(double seconds) {
        nanos.values().removeIf(last -> time.secondsSince(last) > seconds);
        return List.copyOf(nanos.keySet());
    }

    /** Forgets everything. */
    public void clear() {
        nanos.clear();
    }
}

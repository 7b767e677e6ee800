package majic.stop;

import java.util.OptionalLong;
import java.util.TreeMap;
import majic.time.WaitLimit;

/** The bytes that passed one place so far, as text of one character a byte, and when each passed. Thread-safe. */
public final class TimedBytes {
    private final StringBuilder bytes = new StringBuilder();
    private final TreeMap<Integer, Long> nanosByEnd = new TreeMap<>();

    /** Appends bytes that passed at a time of the system's clock, ns. */
    public void add(String text, long nanos) {
        synchronized (bytes) {
            bytes.append(text);
            nanosByEnd.put(bytes.length(), nanos);
        }
    }

    /** Returns the number of bytes so far. */
    public int length() {
        synchronized (bytes) {
            return bytes.length();
        }
    }

    /** Returns what passed after the first bytes. */
    String since(int from) {
        synchronized (bytes) {
            return bytes.substring(from);
        }
    }

    /** Waits until a text has passed, after the first bytes; fails if it does not pass in time. */
    void await(String text, int from) {
        WaitLimit.until("'" + text + "' to pass after the first " + from + " bytes", () -> hasPassed(text, from));
    }

    private boolean hasPassed(String text, int from) {
        synchronized (bytes) {
            return bytes.indexOf(text, from) >= 0;
        }
    }

    /** Returns when a text passed, after the first bytes, ns of the system's clock; empty if it did not. */
    public OptionalLong nanosOf(String text, int from) {
        synchronized (bytes) {
            int at = bytes.indexOf(text, from);
            return at < 0
                    ? OptionalLong.empty()
                    : OptionalLong.of(
                            nanosByEnd.ceilingEntry(at + text.length()).getValue());
        }
    }
}

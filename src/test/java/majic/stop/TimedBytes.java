package majic.stop;

import java.util.OptionalLong;
import java.util.TreeMap;

/** The bytes that passed one place so far, as text of one character a byte, and when each passed. Thread-safe. */
public final class TimedBytes {
    private final StringBuilder bytes = new StringBuilder();
    private final TreeMap<Integer, Long> nanosByEnd = new TreeMap<>();

    /** Appends bytes that passed at a time of the system's clock, ns. */
    public void add(String text, long nanos) {
        synchronized (bytes) {
            bytes.append(text);
            nanosByEnd.put(bytes.length(), nanos);
            bytes.notifyAll();
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

    /** Waits until a text has passed, after the first bytes. */
    void await(String text, int from) throws InterruptedException {
        synchronized (bytes) {
            while (bytes.indexOf(text, from) < 0) {
                bytes.wait();
            }
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

package majic.mavlink.line;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import majic.time.TimeSource;

/** The open connections of this program: robots with the same endpoint share one. Thread-safe. */
public final class VehicleLines {
    private static final Map<String, Entry> OPEN = new HashMap<>();

    private VehicleLines() {}

    /** A connection and its number of users. */
    private static final class Entry {
        private int users;
        private final SharedLine line;

        private Entry(SharedLine line) {
            this.line = line;
        }
    }

    /**
     * Joins a connection, which the first user opens.
     *
     * @param endpoint where the vehicles are
     * @param timeoutMs how long opening may take, ms
     * @param time the clock of the vehicles
     * @param listener receives what arrives from now on
     * @return to be closed by the caller
     * @throws IOException if it cannot be opened; the message is a sentence
     */
    public static VehicleLine join(VehicleEndpoint endpoint, int timeoutMs, TimeSource time, FrameListener listener)
            throws IOException {
        Entry entry = enter(endpoint, time);
        try {
            entry.line.openOnce(timeoutMs);
        } catch (IOException e) {
            leave(endpoint, entry);
            throw e;
        }
        entry.line.add(listener);
        return new VehicleLine(entry.line, listener, () -> leave(endpoint, entry));
    }

    private static Entry enter(VehicleEndpoint endpoint, TimeSource time) {
        synchronized (OPEN) {
            Entry entry = OPEN.get(endpoint.key());
            if (entry == null || entry.line.cause() != null) {
                entry = new Entry(new SharedLine(endpoint.links().get(), time));
                OPEN.put(endpoint.key(), entry);
            }
            entry.users++;
            return entry;
        }
    }

    private static void leave(VehicleEndpoint endpoint, Entry entry) {
        boolean last;
        synchronized (OPEN) {
            entry.users--;
            last = entry.users == 0;
            if (last) {
                OPEN.remove(endpoint.key(), entry);
            }
        }
        if (last) {
            entry.line.close();
        }
    }
}

package majic.mavlink.line;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import majic.time.TimeSource;

/** The open connections of this program: robots with the same endpoint share one. Thread-safe. */
public final class VehicleLines {
    /** One that its last user has left stays here until its port is closed. */
    private static final Map<String, Entry> OPEN = new HashMap<>();

    private VehicleLines() {}

    /** A connection and its users. */
    private static final class Entry {
        private final SharedLine line;
        private final VehicleEndpoint endpoint;
        private int users;
        private boolean left;

        private Entry(SharedLine line, VehicleEndpoint endpoint) {
            this.line = line;
            this.endpoint = endpoint;
        }

        private boolean isOver() {
            return left || line.cause() != null;
        }
    }

    /**
     * Joins a connection, which the first user opens. A connection to the same port that is being closed is awaited.
     *
     * @param endpoint where the vehicles are
     * @param timeoutMs how long opening may take, ms
     * @param time the clock of the vehicles
     * @param listener receives what arrives from now on
     * @return to be closed by the caller
     * @throws IOException if it cannot be opened, or is open with another speed; the message is a sentence
     */
    public static VehicleLine join(VehicleEndpoint endpoint, int timeoutMs, TimeSource time, FrameListener listener)
            throws IOException {
        while (true) {
            Entry entry = enter(endpoint, time);
            try {
                if (entry.line.openOnce(timeoutMs) && entry.line.add(listener)) {
                    return new VehicleLine(entry.line, listener, () -> leave(entry));
                }
            } catch (IOException e) {
                leave(entry);
                throw e;
            }
            // It has ended meanwhile.
            leave(entry);
        }
    }

    private static Entry enter(VehicleEndpoint endpoint, TimeSource time) throws IOException {
        synchronized (OPEN) {
            Entry entry = OPEN.get(endpoint.key());
            if (entry == null || entry.isOver()) {
                entry = new Entry(
                        new SharedLine(endpoint.links().get(), time, entry == null ? null : entry.line), endpoint);
                OPEN.put(endpoint.key(), entry);
            }
            if (entry.endpoint.baud() != endpoint.baud()) {
                throw new IOException(otherSpeed(entry, endpoint));
            }
            entry.users++;
            return entry;
        }
    }

    private static String otherSpeed(Entry open, VehicleEndpoint wanted) {
        String systems = open.line.systems().mapToObj(String::valueOf).collect(Collectors.joining(", "));
        return "the serial port " + wanted.title() + " is open at " + open.endpoint.baud()
                + (systems.isEmpty()
                        ? " baud for another robot, and has one speed"
                        : " baud for vehicle " + systems + ", and has one speed")
                + ": use ?baud=" + open.endpoint.baud() + " in both addresses, or disconnect that robot first";
    }

    private static void leave(Entry entry) {
        synchronized (OPEN) {
            entry.users--;
            if (entry.users > 0) {
                return;
            }
            entry.left = true;
        }
        entry.line.close();
        synchronized (OPEN) {
            OPEN.remove(entry.endpoint.key(), entry);
        }
    }
}

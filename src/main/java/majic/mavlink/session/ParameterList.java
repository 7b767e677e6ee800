package majic.mavlink.session;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.ParameterValue;
import majic.time.TimeSource;

/**
 * The names of all parameters of an autopilot, which it is asked for once, when something needs them. Values that were
 * lost on the way are asked for again by their places. Thread-safe; waits for nothing.
 */
final class ParameterList {
    /** The list has ended when nothing has come for this time, seconds. */
    private static final double QUIET_S = 1;

    /** So many lost values are asked for at once. */
    private static final int MOST_AT_ONCE = 20;

    /** Without a further value the rest is not asked for again. */
    private static final int MOST_ROUNDS = 5;

    private final VehicleSession session;
    private final TimeSource time;
    private final Set<String> names = new ConcurrentSkipListSet<>();
    private final BitSet arrived = new BitSet();
    private int count;
    private int rounds;
    private long newestNanos;
    private boolean asked;

    ParameterList(VehicleSession session, TimeSource time) {
        this.session = session;
        this.time = time;
    }

    /** Takes a value; on the reader thread. */
    synchronized void take(ParameterValue value) {
        names.add(value.name());
        if (value.index() != ParameterValue.NO_INDEX) {
            count = value.count();
            newestNanos = time.nanos();
            if (!arrived.get(value.index())) {
                arrived.set(value.index());
                rounds = 0;
            }
        }
    }

    /** Returns the names that have come so far; the first call asks for all. */
    List<String> names() {
        boolean first;
        synchronized (this) {
            first = !asked;
            asked = true;
            newestNanos = first ? time.nanos() : newestNanos;
        }
        if (first) {
            session.send(MavlinkRequests.listParameters(session.system()));
        }
        return List.copyOf(names);
    }

    /** Asks again for what is missing; called often. */
    void check() {
        int[] missing = missing();
        if (missing.length == 0) {
            return;
        }
        if (missing[0] < 0) {
            session.send(MavlinkRequests.listParameters(session.system()));
            return;
        }
        for (int index : missing) {
            session.send(MavlinkRequests.readParameter(session.system(), index));
        }
    }

    /** The places to ask for now; -1 for all, if none has come. */
    private synchronized int[] missing() {
        if (!asked || rounds >= MOST_ROUNDS || time.secondsSince(newestNanos) < QUIET_S) {
            return new int[0];
        }
        rounds++;
        newestNanos = time.nanos();
        if (arrived.isEmpty()) {
            return new int[] {-1};
        }
        int[] found = new int[MOST_AT_ONCE];
        int size = 0;
        for (int index = arrived.nextClearBit(0);
                index < count && size < MOST_AT_ONCE;
                index = arrived.nextClearBit(index + 1)) {
            found[size++] = index;
        }
        return Arrays.copyOf(found, size);
    }
}

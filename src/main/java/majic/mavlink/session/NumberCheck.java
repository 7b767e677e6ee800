package majic.mavlink.session;

import majic.mavlink.message.VehicleHeartbeat;
import majic.time.TimeSource;

/**
 * Distinguishes the restart of an autopilot from a second vehicle that sends with the same number from the same
 * address: a restart sets the clock since power-on back once; with two vehicles it jumps back and forth, and their
 * heartbeats may name two kinds of vehicles. Two of the same kind that were switched on within 2 s of each other are
 * not found. For the reader thread.
 */
final class NumberCheck {
    /** Frames may overtake each other by less than this, ms. */
    private static final long JUMP_MS = 2000;

    /** So many jumps, or changes of the kind, in a row show that there are two. */
    private static final int TIMES = 3;

    /** Jumps that are farther apart are not in a row, seconds. */
    private static final double APART_S = 10;

    private final TimeSource time;
    private final Row jumps = new Row();
    private final Row kinds = new Row();
    private long bootMs = -1;
    private long bootNanos;
    private boolean isForth;
    private int kind = -1;

    /** What a message shows. */
    enum Finding {
        /** Nothing new. */
        NONE,
        /** The autopilot has restarted. */
        RESTARTED,
        /** There are two vehicles. */
        TWO
    }

    /** Events of which each comes soon after the one before. */
    private final class Row {
        private int length;
        private long newestNanos;

        int add() {
            length = length > 0 && time.secondsSince(newestNanos) < APART_S ? length + 1 : 1;
            newestNanos = time.nanos();
            return length;
        }
    }

    NumberCheck(TimeSource time) {
        this.time = time;
    }

    /**
     * Takes the time of a report; of one kind only, since some autopilots have another clock for each.
     *
     * @param newestMs since power-on
     */
    Finding clock(long newestMs) {
        long before = bootMs;
        double passedMs = 1000 * time.secondsSince(bootNanos);
        bootMs = newestMs;
        bootNanos = time.nanos();
        if (before < 0) {
            return Finding.NONE;
        }
        if (newestMs > before + passedMs + JUMP_MS) {
            isForth = true;
        }
        if (newestMs >= before - JUMP_MS) {
            return Finding.NONE;
        }
        int row = jumps.add();
        boolean wasForth = isForth;
        isForth = false;
        if (row == 1 || !wasForth) {
            return Finding.RESTARTED;
        }
        return row == TIMES ? Finding.TWO : Finding.NONE;
    }

    /** Takes a heartbeat of the autopilot. */
    Finding heartbeat(VehicleHeartbeat heartbeat) {
        int before = kind;
        kind = heartbeat.type() << 8 | heartbeat.autopilot();
        return before >= 0 && before != kind && kinds.add() == TIMES ? Finding.TWO : Finding.NONE;
    }
}

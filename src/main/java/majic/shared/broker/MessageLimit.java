package majic.shared.broker;

import majic.time.TimeSource;

/** Limits how many messages of one kind are used, and counts those that are not. Thread-safe. */
public final class MessageLimit {
    /** How often left out messages are reported at most, seconds. */
    private static final double REPORT_S = 10;

    private final TimeSource time;
    private final double perSecond;
    private double room;
    private long filledNanos;
    private long leftOut;
    private long reportedNanos;
    private boolean reported;

    /**
     * Begins with all messages of a second.
     *
     * @param time the clock
     * @param perSecond how many messages are used in the long run; as many may come at once
     */
    public MessageLimit(TimeSource time, double perSecond) {
        this.time = time;
        this.perSecond = perSecond;
        this.room = perSecond;
        this.filledNanos = time.nanos();
    }

    /**
     * Returns whether one more message is used; counts it if not.
     *
     * @return false if too many have come
     */
    public synchronized boolean allows() {
        long now = time.nanos();
        room = Math.min(perSecond, room + (now - filledNanos) / 1e9 * perSecond);
        filledNanos = now;
        if (room < 1) {
            leftOut++;
            return false;
        }
        room--;
        return true;
    }

    /**
     * Returns how many messages were left out since the last report, if another one is due.
     *
     * @return 0 if none was left out, or the last report was less than 10 s ago
     */
    public synchronized long countToReport() {
        boolean due = leftOut > 0 && (!reported || time.secondsSince(reportedNanos) >= REPORT_S);
        if (!due) {
            return 0;
        }
        long count = leftOut;
        leftOut = 0;
        reported = true;
        reportedNanos = time.nanos();
        return count;
    }
}

package majic.aibo.urbi;

import org.jspecify.annotations.Nullable;

/**
 * Checks with pings that a connection without regular reports still reaches the dog, so that a stop connection that died
 * in silence is not noticed by the stop that needed it. One ping at a time (URBI sheet 9). Used by the keeper's thread.
 */
public final class PingProbe {
    private static final double PERIOD_S = 1;

    /** An engine that takes two seconds to answer is slow, not dead. */
    private static final double PATIENCE_S = 5;

    private final UrbiConnection connection;
    private final Tags tags;
    private final Waiting waiting;
    private final DogClock clock;
    private @Nullable UrbiRequest ping;
    private long sentNanos;

    public PingProbe(UrbiConnection connection, Tags tags, Waiting waiting, DogClock clock) {
        this.connection = connection;
        this.tags = tags;
        this.waiting = waiting;
        this.clock = clock;
        this.sentNanos = waiting.time().nanos();
    }

    public UrbiConnection connection() {
        return connection;
    }

    /** Pings when it is time; false when the dog has owed an answer for too long. */
    public boolean beats() {
        double seconds = waiting.time().secondsSince(sentNanos);
        UrbiRequest open = ping;
        if (open != null && !open.isDone()) {
            return seconds <= PATIENCE_S;
        }
        if (open != null && open.failure() == null) {
            clock.answered(open.doneMs(), sentNanos);
        }
        if (seconds >= PERIOD_S) {
            sentNanos = waiting.time().nanos();
            ping = connection.ping(tags);
        }
        return true;
    }

    /** Why the connection counts as dead. */
    public static String silence() {
        return "no answer from the dog for " + (int) PATIENCE_S + " s";
    }
}

package majic.aibo.urbi;

import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * Checks with pings that a connection without regular reports still reaches the dog, so that a dead stop connection is
 * noticed before a stop needs it. One ping at a time (URBI sheet 9). Used by the robot's timer thread.
 */
public final class PingProbe {
    private static final double PERIOD_S = 1;

    /** An engine that takes two seconds to answer is slow, not dead. */
    private static final double TIMEOUT_S = 5;

    private final UrbiConnection connection;
    private final Tags tags;
    private final RobotWait waiting;
    private final DogClock clock;
    private @Nullable UrbiRequest ping;
    private long sentNanos;

    public PingProbe(UrbiConnection connection, Tags tags, RobotWait waiting, DogClock clock) {
        this.connection = connection;
        this.tags = tags;
        this.waiting = waiting;
        this.clock = clock;
        this.sentNanos = waiting.time().nanos();
    }

    public UrbiConnection connection() {
        return connection;
    }

    /** Sends a ping when it is due; returns false when the answer to the last one is overdue. */
    public boolean check() {
        double seconds = waiting.time().secondsSince(sentNanos);
        UrbiRequest open = ping;
        if (open != null && !open.isDone()) {
            return seconds <= TIMEOUT_S;
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

    /** The reason to report when {@link #check} has returned false. */
    public static String silence() {
        return "no answer from the dog for " + (int) TIMEOUT_S + " s";
    }
}

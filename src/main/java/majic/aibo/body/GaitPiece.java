package majic.aibo.body;

import majic.aibo.urbi.UrbiRequest;
import majic.bot.Pose;
import majic.driver.DeadReckoning;
import org.jspecify.annotations.Nullable;

/** One piece of a gait: the commanded amount, and the amount covered by the time stamps of the server. Thread-safe. */
public final class GaitPiece implements DeadReckoning.Segment {
    /** The longest walk that is sent to the dog, ms: it would go on for this time if all connections failed. */
    public static final double LONGEST_MS = 2000;

    /** The tolerance of the dog's time stamps for begin and end: two cycles and something (URBI sheet 15). */
    private static final double SLACK_MS = 100;

    /** A walk that lasted so much longer than ordered did not go as ordered, ms. */
    private static final double TOO_LONG_MS = 500;

    private final Stride stride;
    private final double amount;
    private final double durationMs;
    private final UrbiRequest ask;

    /** Covers an amount, mm or degrees, always positive. */
    public GaitPiece(Stride stride, double amount, UrbiRequest ask) {
        this.stride = stride;
        this.amount = amount;
        this.durationMs = amount * stride.msPerUnit();
        this.ask = ask;
    }

    public Gait gait() {
        return stride.gait();
    }

    /** How long it is to last, ms. */
    public double durationMs() {
        return durationMs;
    }

    /** How fast it goes, mm/s or deg/s with sign. */
    double unitsPerSecond() {
        return gait().sign() * stride.unitsPerSecond();
    }

    /** The call to send to the dog. */
    public String call() {
        return gait().call(Math.round(durationMs));
    }

    /** What it has covered at a time of the server's clock, mm or degrees with sign. */
    public double coveredAt(long serverMs) {
        return gait().sign() * amount * shareAt(serverMs);
    }

    /** What it has covered in all, once it is over. */
    public double covered() {
        return coveredAt(Long.MAX_VALUE);
    }

    /** Why it has not covered its amount though the dog has ended it, as half a sentence; null if it has. */
    public @Nullable String flaw() {
        if (ask.beganMs() < 0) {
            return "the dog did not report the begin of its walk";
        }
        double excessMs = ask.doneMs() - ask.beganMs() - durationMs;
        if (excessMs < -SLACK_MS) {
            return "another program, or its guard, ended the walk";
        }
        return excessMs > TOO_LONG_MS ? "the dog ended its walk " + Math.round(excessMs) + " ms late" : null;
    }

    @Override
    public Pose at(Pose start, long serverMs) {
        double covered = coveredAt(serverMs);
        return gait().isWalk() ? start.after(covered, 0) : start.after(0, covered);
    }

    private double shareAt(long serverMs) {
        if (ask.beganMs() < 0) {
            return 0;
        }
        long end = ask.isDone() ? Math.min(serverMs, ask.doneMs()) : serverMs;
        return Math.max(0, Math.min(1, (end - ask.beganMs()) / durationMs));
    }
}

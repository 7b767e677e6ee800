package majic.aibo;

/**
 * One piece of a gait: how much it is to cover, and by the server's clock how much of it the dog has done. Safe from any
 * thread.
 */
final class Piece {
    /** The longest time the dog is ever told to walk, ms: so long it would walk on if all links fell silent. */
    static final double LONGEST_MS = 2000;

    /** A timed gait ends 0 to 2 cycles of 32 ms late (URBI sheet 3, 15): ask for the mean of it less ... */
    private static final double OVERRUN_MS = 32;

    /** ... but never for much less. */
    private static final double OVERRUN_SHARE = 0.05;

    private final Gait gait;
    private final double amount;
    private final double durationMs;
    private final Ask ask;

    /** Covers an amount, mm or degrees, always positive. */
    Piece(Gait gait, double amount, double msPerUnit, Ask ask) {
        this.gait = gait;
        this.amount = amount;
        this.durationMs = amount * msPerUnit;
        this.ask = ask;
    }

    Gait gait() {
        return gait;
    }

    /** How long it is to last, ms. */
    double durationMs() {
        return durationMs;
    }

    /** What to ask the dog for. */
    String call() {
        return gait.call(Math.round(durationMs - Math.min(OVERRUN_MS, durationMs * OVERRUN_SHARE)));
    }

    /** What it has covered at a time of the server's clock, mm or degrees with sign. */
    double coveredAt(long serverMs) {
        return gait.sign() * amount * shareAt(serverMs);
    }

    /** What it has covered in all, once it is over. */
    double covered() {
        return coveredAt(Long.MAX_VALUE);
    }

    private double shareAt(long serverMs) {
        if (ask.beganMs() < 0) {
            return 0;
        }
        long end = ask.isDone() ? Math.min(serverMs, ask.doneMs()) : serverMs;
        double askedMs = durationMs - Math.min(OVERRUN_MS, durationMs * OVERRUN_SHARE);
        return Math.max(0, Math.min(1, (end - ask.beganMs()) / askedMs));
    }
}

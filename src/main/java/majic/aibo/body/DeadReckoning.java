package majic.aibo.body;

import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/** Estimates the position from the gaits that were sent; the dog has no odometry (URBI sheet 15). Thread-safe. */
public final class DeadReckoning {
    private Pose settled = Pose.START;
    private @Nullable GaitPiece walking;

    /** A piece begins where the last one ended. */
    public synchronized void begin(GaitPiece piece) {
        settle(Long.MAX_VALUE);
        walking = piece;
    }

    /** The piece under way is over. */
    public synchronized void end() {
        settle(Long.MAX_VALUE);
    }

    private void settle(long serverMs) {
        settled = at(serverMs);
        walking = null;
    }

    /** Where it is at a time of the server's clock. */
    synchronized Pose at(long serverMs) {
        GaitPiece piece = walking;
        if (piece == null) {
            return settled;
        }
        double covered = piece.coveredAt(serverMs);
        return piece.gait().isWalk() ? settled.after(covered, 0) : settled.after(0, covered);
    }
}

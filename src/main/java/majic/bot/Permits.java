package majic.bot;

import java.util.function.Supplier;

/** The permit in force for one robot. Thread-safe. */
final class Permits {
    private Permit current = new Permit();
    private boolean latched;
    private boolean closed;

    synchronized Permit current() {
        return current;
    }

    /** Ends all motions begun under the present permit; later ones get a new one, unless latched. */
    synchronized void revokeAll(Supplier<? extends BotException> reason) {
        current.revoke(reason);
        if (!latched) {
            current = new Permit();
        }
    }

    /** Ends all motions and gives out only revoked permits from now on. */
    synchronized void latch(Supplier<? extends BotException> reason) {
        if (closed) {
            return;
        }
        current.revoke(() -> new MotionStopped("stopped"));
        current = new Permit();
        current.revoke(reason);
        latched = true;
    }

    /** As {@link #latch}, for good: {@link #unlatch} does nothing any more. The first reason stays. */
    synchronized void close(Supplier<? extends BotException> reason) {
        if (!closed) {
            latch(reason);
            closed = true;
        }
    }

    synchronized void unlatch() {
        if (latched && !closed) {
            latched = false;
            current = new Permit();
        }
    }
}

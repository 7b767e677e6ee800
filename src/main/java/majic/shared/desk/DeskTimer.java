package majic.shared.desk;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.DoubleSupplier;
import majic.time.Signal;
import majic.time.TimeSource;

/** The one timer thread of a desk, for all of its robots. Thread-safe. */
final class DeskTimer implements AutoCloseable {
    /** The longest time between two looks, seconds. */
    static final double PERIOD_S = 0.1;

    private static final Logger LOG = System.getLogger(DeskTimer.class.getName());

    private final Signal signal;
    private final DoubleSupplier tick;
    private final Thread thread;
    private volatile boolean awake;
    private volatile boolean closed;

    /** @param tick does what is due; returns the seconds until the next look */
    DeskTimer(TimeSource time, String name, DoubleSupplier tick) {
        this.signal = time.signal();
        this.tick = tick;
        this.thread = time.thread(name, this::run);
    }

    void start() {
        thread.start();
    }

    /** Looks at once. */
    void wake() {
        awake = true;
        signal.raise();
    }

    private void run() {
        double nextS = 0;
        try {
            while (!closed) {
                signal.await(() -> awake || closed, nextS);
                awake = false;
                nextS = closed ? 0 : tick();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** A failure must not end the watch over heartbeats. */
    private double tick() {
        try {
            return tick.getAsDouble();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "the timer of a desk failed", e);
            return PERIOD_S;
        }
    }

    @Override
    public void close() {
        closed = true;
        signal.raise();
    }
}

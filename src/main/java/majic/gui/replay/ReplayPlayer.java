package majic.gui.replay;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * The position in a recording, which advances while it plays. Works on a thread of its own, 20 times a second.
 * Thread-safe.
 */
final class ReplayPlayer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(ReplayPlayer.class.getName());
    private static final long PERIOD_MS = 50;

    private final double beginS;
    private final double endS;
    private final Screen screen;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(ReplayPlayer::thread);
    private double position;
    private double speed = 1;
    private boolean playing;
    private boolean switched;
    private @Nullable Double wanted;
    private long lastNanos;

    /** Shows what was recorded; called on the thread of the player. */
    interface Screen {
        /** Shows a time without what lies before it. */
        void jump(double toS);

        /** Shows the next piece. */
        void advance(double fromS, double toS);

        /** The position or the playing has changed. */
        void moved(double positionS, boolean playing);

        /** Playing has reached the end, where it pauses. */
        void ended();
    }

    /** Creates a player at the beginning of a recording; {@link #start()} starts its thread. */
    ReplayPlayer(double beginS, double endS, Screen screen) {
        this.beginS = beginS;
        this.endS = endS;
        this.screen = screen;
        this.position = beginS;
        this.wanted = beginS;
    }

    private static Thread thread(Runnable body) {
        Thread thread = new Thread(body, "replay");
        thread.setDaemon(true);
        return thread;
    }

    void start() {
        lastNanos = System.nanoTime();
        clock.scheduleWithFixedDelay(this::run, 0, PERIOD_MS, TimeUnit.MILLISECONDS);
    }

    private void run() {
        long now = System.nanoTime();
        try {
            tick((now - lastNanos) / 1e9);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "the replay could not be continued", e);
        }
        lastNanos = now;
    }

    /** Plays for so many seconds of real time. */
    void tick(double elapsedS) {
        double from;
        double to;
        boolean jumps;
        boolean ends;
        synchronized (this) {
            from = position;
            jumps = wanted != null;
            if (!jumps && !playing && !switched) {
                return;
            }
            to = wanted != null ? wanted : playing ? Math.min(endS, position + elapsedS * speed) : position;
            wanted = null;
            switched = false;
            position = to;
            ends = playing && !jumps && to >= endS;
            playing &= to < endS;
        }
        if (jumps) {
            screen.jump(to);
        } else if (to > from) {
            screen.advance(from, to);
        }
        screen.moved(to, isPlaying());
        if (ends) {
            screen.ended();
        }
    }

    /** Begins to play; at the end from the beginning. */
    synchronized void play() {
        if (position >= endS) {
            wanted = beginS;
        }
        playing = true;
    }

    synchronized void pause() {
        playing = false;
        switched = true;
    }

    synchronized boolean isPlaying() {
        return playing;
    }

    /** Continues at another time, seconds of the recording. */
    synchronized void jump(double toS) {
        wanted = Math.max(beginS, Math.min(endS, toS));
    }

    synchronized double speed() {
        return speed;
    }

    /** Sets how many seconds of the recording are played in a second. */
    synchronized void setSpeed(double times) {
        speed = times;
    }

    synchronized double position() {
        Double jumping = wanted;
        return jumping == null ? position : jumping;
    }

    @Override
    public void close() {
        clock.shutdownNow();
    }
}

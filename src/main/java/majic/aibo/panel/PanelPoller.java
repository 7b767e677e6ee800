package majic.aibo.panel;

import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.aibo.body.LedReadings;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotException;
import majic.driver.RobotWait;
import majic.panel.FrameRate;
import majic.text.Texts;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Polls the values that are needed only while the panel is visible: pictures, and the state of the LEDs and ears. Has
 * its own thread meanwhile, because no other may wait for a picture. After each picture the connection is left to the
 * readings for at least as long as the picture took; on a link on which a picture takes long, none is requested while
 * the dog moves. Thread-safe.
 */
public final class PanelPoller {
    private static final Texts TEXTS = Texts.of(PanelPoller.class);
    private static final double LEAST_PERIOD_S = 0.1;
    private static final double AFTER_FAILURE_S = 1;

    /** A picture that takes longer would make the readings too old for a dog that moves, s. */
    private static final double LONG_S = 0.5;

    /** Receives the pictures. Called on the poller's thread; may block. */
    public interface PictureReceiver {
        /** A picture came. */
        void see(UrbiValue picture, double perSecond);

        /** There is none, for this reason. */
        void miss(String why);
    }

    private final RobotWait waiting;
    private final Supplier<@Nullable UrbiConnection> connection;
    private final BooleanSupplier moving;
    private final PictureReceiver receiver;
    private final Camera camera;
    private final Tags tags = new Tags();
    private @Nullable PollRun current;

    /**
     * Makes a poller that does not poll yet.
     *
     * @param connection the one for sensors and settings that is open now; null while none is
     * @param moving whether a motion or a drive is under way
     */
    public PanelPoller(
            RobotWait waiting,
            Supplier<@Nullable UrbiConnection> connection,
            BooleanSupplier moving,
            PictureReceiver receiver) {
        this.waiting = waiting;
        this.connection = connection;
        this.moving = moving;
        this.receiver = receiver;
        this.camera = new Camera(waiting);
    }

    /** Begins or ends polling. Never blocks. */
    public synchronized void look(boolean whether) {
        PollRun last = current;
        if (whether && last == null) {
            PollRun begun = new PollRun();
            current = begun;
            waiting.time().thread("aibo panel poller", begun::run).start();
        } else if (!whether && last != null) {
            last.over = true;
            current = null;
            waiting.changes().raise();
        }
    }

    /** The polling while the panel is visible. */
    private final class PollRun {
        private final FrameRate rate = new FrameRate();
        private volatile boolean over;

        private void run() {
            while (!over) {
                UrbiConnection on = connection.get();
                if (on == null) {
                    receiver.miss(TEXTS.get("camera.notConnected"));
                    waiting.await(() -> over || connection.get() != null, Signal.FOR_EVER);
                } else {
                    look(on);
                }
            }
        }

        private void look(UrbiConnection on) {
            String tag = tags.next();
            try {
                on.send(LedReadings.order(tag, on.version()));
                while (sees(on)) {
                    picture(on);
                }
                on.send(LedReadings.stop(tag));
            } catch (BotException e) {
                waiting.await(() -> !sees(on), AFTER_FAILURE_S);
            }
        }

        private boolean sees(UrbiConnection on) {
            return !over && connection.get() == on;
        }

        private void picture(UrbiConnection on) {
            long askedNanos = waiting.time().nanos();
            try {
                UrbiValue picture = camera.next(on, () -> !sees(on));
                if (picture != null) {
                    long nanos = waiting.time().nanos();
                    receiver.see(picture, rate.arrived(nanos));
                    double tookS = (nanos - askedNanos) / 1e9;
                    pause(on, Math.max(tookS, LEAST_PERIOD_S - tookS));
                    awaitRest(on, tookS);
                }
            } catch (UrbiRefusal e) {
                receiver.miss(String.valueOf(e.getMessage()));
                pause(on, AFTER_FAILURE_S);
            }
        }

        private void awaitRest(UrbiConnection on, double tookS) {
            if (tookS > LONG_S && moving.getAsBoolean()) {
                receiver.miss(TEXTS.get("camera.slow", String.format(Locale.ROOT, "%.1f", tookS)));
                waiting.await(() -> !sees(on) || !moving.getAsBoolean(), Signal.FOR_EVER);
            }
        }

        private void pause(UrbiConnection on, double seconds) {
            waiting.await(() -> !sees(on), seconds);
        }
    }
}

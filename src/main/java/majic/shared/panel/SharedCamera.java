package majic.shared.panel;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.panel.PictureFile;
import majic.panel.PictureView;
import majic.text.Texts;

/**
 * The camera of a shared robot: while its picture is visible, a thread requests and decodes one picture after the
 * other.
 */
final class SharedCamera {
    private static final Texts TEXTS = Texts.of(SharedCamera.class);
    private static final int WIDTH = 208;
    private static final int HEIGHT = 156;

    /** Between a picture and the next request, ms: pictures must not crowd out the robot's commands. */
    private static final int PAUSE_MS = 500;

    private final PictureView view = new PictureView(WIDTH, HEIGHT);
    private final MajicBot bot;
    private final Supplier<byte[]> pictures;
    private final AtomicBoolean requesting = new AtomicBoolean();
    private volatile boolean watched;

    /**
     * @param pictures requests a picture, a JPEG file; blocks, and throws a BotException with the reason if there is
     *     none
     */
    SharedCamera(MajicBot bot, Supplier<byte[]> pictures) {
        this.bot = bot;
        this.pictures = pictures;
        view.miss(TEXTS.get("camera.none"));
        view.setToolTipText(TEXTS.get("camera.tip"));
        view.setTitle(() -> TEXTS.get("camera.robot", bot.name()));
        view.whenWatched(this::watch);
    }

    PictureView view() {
        return view;
    }

    private void watch(boolean seen) {
        watched = seen;
        if (seen && requesting.compareAndSet(false, true)) {
            Thread thread = new Thread(this::requestAll, "camera of " + bot.name());
            thread.setDaemon(true);
            thread.start();
        }
    }

    private void requestAll() {
        try {
            while (watched) {
                requestOne();
                Thread.sleep(PAUSE_MS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            requesting.set(false);
        }
    }

    private void requestOne() {
        if (!bot.isConnected()) {
            return;
        }
        try {
            show(pictures.get());
        } catch (BotException e) {
            miss(String.valueOf(e.getMessage()));
        }
    }

    /** Decodes and shows a picture; not on the event dispatch thread. */
    void show(byte[] jpeg) {
        try {
            BufferedImage image = PictureFile.decode(jpeg);
            SwingUtilities.invokeLater(() -> view.show(image, ""));
        } catch (IOException e) {
            miss(String.valueOf(e.getMessage()));
        }
    }

    /** Shows why there is no picture; on any thread. */
    void miss(String why) {
        SwingUtilities.invokeLater(() -> view.miss(why));
    }
}

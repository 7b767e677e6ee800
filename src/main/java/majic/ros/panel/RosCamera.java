package majic.ros.panel;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.panel.FrameRate;
import majic.panel.PictureFile;
import majic.panel.PictureView;
import majic.text.Texts;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The camera's pictures on their way to the screen. They are decoded on a background thread, one at a time; if they
 * come faster, only the newest is decoded. {@link #view} and {@link #miss} are for the event dispatch thread, the rest
 * for any.
 */
final class RosCamera implements BotListener {
    private static final Texts TEXTS = Texts.of(RosCamera.class);
    private static final int WIDTH = 208;
    private static final int HEIGHT = 156;

    private final PictureView view = new PictureView(WIDTH, HEIGHT);
    private final TimeSource time;
    private final AtomicReference<@Nullable Supplier<byte[]>> newest = new AtomicReference<>();
    private final AtomicBoolean decoding = new AtomicBoolean();
    private final FrameRate rate = new FrameRate();

    RosCamera(TimeSource time) {
        this.time = time;
        view.miss(TEXTS.get("camera.none"));
        view.setToolTipText(TEXTS.get("camera.tip"));
    }

    PictureView view() {
        return view;
    }

    void miss(String why) {
        view.miss(why);
    }

    @Override
    public void pictureTaken(MajicBot bot, Supplier<byte[]> file) {
        see(file);
    }

    /** Shows a picture soon. */
    void see(Supplier<byte[]> file) {
        newest.set(file);
        if (decoding.compareAndSet(false, true)) {
            CompletableFuture.runAsync(this::decodeAll, task -> new Thread(task, "ros picture").start());
        }
    }

    /** A picture that comes between the last look and the end is decoded by the next one's thread. */
    private void decodeAll() {
        try {
            for (Supplier<byte[]> file = newest.getAndSet(null); file != null; file = newest.getAndSet(null)) {
                decode(file);
            }
        } finally {
            decoding.set(false);
        }
    }

    private void decode(Supplier<byte[]> file) {
        try {
            BufferedImage image = PictureFile.decode(file.get());
            double perSecond = rate.arrived(time.nanos());
            SwingUtilities.invokeLater(() -> view.show(image, caption(perSecond)));
        } catch (IOException e) {
            SwingUtilities.invokeLater(() -> view.miss(String.valueOf(e.getMessage())));
        }
    }

    /** The first picture has no rate. */
    private static String caption(double perSecond) {
        return perSecond > 0 ? TEXTS.get("camera.rate", String.format(Locale.ROOT, "%.1f", perSecond)) : "";
    }
}

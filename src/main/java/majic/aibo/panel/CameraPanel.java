package majic.aibo.panel;

import java.awt.image.BufferedImage;
import java.util.Locale;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiValue;
import majic.panel.PictureView;
import org.jspecify.annotations.Nullable;

/**
 * The camera's pictures on their way to the screen: decoded on the poller's thread, shown by the next refresh. For the
 * event thread, except what a poller calls.
 */
final class CameraPanel implements PanelPoller.PictureReceiver {
    private static final int WIDTH = 208;
    private static final int HEIGHT = 160;

    private final PictureView view = new PictureView(WIDTH, HEIGHT);
    private volatile Seen newest = new Seen(null, "no picture yet");
    private Seen shown = newest;

    /** A picture with its caption, or in words why there is none. */
    private record Seen(@Nullable BufferedImage image, String words) {}

    CameraPanel() {
        view.miss(newest.words());
        view.setToolTipText("What the camera sees; asked for only while this tab is shown");
    }

    PictureView view() {
        return view;
    }

    @Override
    public void see(UrbiValue picture, double perSecond) {
        try {
            BufferedImage image = CameraPicture.of(picture);
            newest = new Seen(image, caption(perSecond));
        } catch (UrbiRefusal e) {
            miss(String.valueOf(e.getMessage()));
        }
    }

    /** The first picture has no rate. */
    private static String caption(double perSecond) {
        return perSecond > 0 ? String.format(Locale.ROOT, "%.1f frames/s", perSecond) : "";
    }

    @Override
    public void miss(String why) {
        newest = new Seen(null, why);
    }

    /** Shows what came last. */
    void refresh() {
        Seen now = newest;
        if (now == shown) {
            return;
        }
        shown = now;
        BufferedImage image = now.image();
        if (image == null) {
            view.miss(now.words());
        } else {
            view.show(image, now.words());
        }
    }
}

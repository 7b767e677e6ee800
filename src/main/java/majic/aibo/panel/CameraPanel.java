package majic.aibo.panel;

import java.awt.image.BufferedImage;
import java.util.Locale;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiValue;
import majic.bot.MajicBot;
import majic.panel.PictureView;
import majic.panel.RefreshTicks;
import majic.team.Member;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * The camera's pictures on their way to the screen: decoded on the poller's thread, then shown on the event thread,
 * also while only a larger copy of the view is visible. For the event thread, except what a poller calls.
 */
final class CameraPanel implements PanelPoller.PictureReceiver {
    private static final Texts TEXTS = Texts.of(CameraPanel.class);
    private static final int WIDTH = 208;
    private static final int HEIGHT = 160;

    private final PictureView view = new PictureView(WIDTH, HEIGHT);
    private final Runnable refresh = this::refresh;
    private volatile Seen newest = new Seen(null, TEXTS.get("camera.none"));
    private Seen shown = newest;
    private volatile Caption caption = new Caption(0, "");

    /** A picture with its caption, or in words why there is none. */
    private record Seen(@Nullable BufferedImage image, String words) {}

    CameraPanel(MajicBot bot) {
        view.setTitle(() -> Member.of(bot)
                .map(member -> TEXTS.get("camera.robot", member.number()))
                .orElseGet(() -> TEXTS.get("camera")));
        view.miss(newest.words());
        view.setToolTipText(TEXTS.get("camera.tip"));
    }

    PictureView view() {
        return view;
    }

    @Override
    public void see(UrbiValue picture, double perSecond) {
        try {
            publish(new Seen(CameraPicture.of(picture), captionOf(Math.round(10 * perSecond))));
        } catch (UrbiRefusal e) {
            miss(String.valueOf(e.getMessage()));
        }
    }

    /** Formats only another rate than that of the last picture. The first picture has no rate. */
    private String captionOf(long tenths) {
        if (caption.tenths() != tenths) {
            String rate = String.format(Locale.ROOT, "%.1f", tenths / 10.0);
            caption = new Caption(tenths, tenths > 0 ? TEXTS.get("camera.rate", rate) : "");
        }
        return caption.words();
    }

    /** The words for a rate, in tenths of a picture a second. */
    private record Caption(long tenths, String words) {}

    @Override
    public void miss(String why) {
        publish(new Seen(null, why));
    }

    private void publish(Seen seen) {
        newest = seen;
        RefreshTicks.once(refresh);
    }

    /** Shows what came last. */
    private void refresh() {
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

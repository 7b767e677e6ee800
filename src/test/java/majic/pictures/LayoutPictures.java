package majic.pictures;

import static majic.pictures.PictureWindow.awaitWindow;

import java.awt.Dimension;
import java.awt.Window;
import java.util.Arrays;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.gui.MajicFrame;
import majic.pictures.DialogPictures.Painter;

/** Compares two robots, gives a panel a window of its own, and makes the window small, for pictures of them. */
final class LayoutPictures {
    private static final Dimension SMALL = new Dimension(700, 540);
    private static final int PIONEER = 2;

    private final MajicFrame frame;
    private final Painter painter;

    LayoutPictures(MajicFrame frame, Painter painter) {
        this.frame = frame;
        this.painter = painter;
    }

    void paint() throws Exception {
        PictureWindow.select(frame, 1);
        PictureWindow.addToSelection(frame, PIONEER);
        painter.paint(frame, "layout-compared");
        PictureWindow.select(frame, PIONEER);
        paintOwnWindow();
        paintSmall();
    }

    private void paintOwnWindow() throws Exception {
        PictureWindow.click(frame, "window" + PIONEER);
        awaitWindow(() -> panelWindow().isPresent());
        JFrame panel = panelWindow().orElseThrow();
        painter.paint(panel, "layout-window");
        painter.paint(frame, "layout-placeholder");
        PictureWindow.click(panel, "window" + PIONEER);
        awaitWindow(() -> PictureWindow.isShowing(frame, "window" + PIONEER));
    }

    private void paintSmall() throws Exception {
        Dimension before = frame.getSize();
        SwingUtilities.invokeAndWait(() -> frame.setSize(SMALL));
        painter.paint(frame, "layout-small");
        SwingUtilities.invokeAndWait(() -> frame.setSize(before));
    }

    private static Optional<JFrame> panelWindow() {
        return Arrays.stream(Window.getWindows())
                .filter(window -> ("robotWindow" + PIONEER).equals(window.getName()) && window.isShowing())
                .filter(JFrame.class::isInstance)
                .map(JFrame.class::cast)
                .findFirst();
    }
}

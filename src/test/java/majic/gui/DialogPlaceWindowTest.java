package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import majic.gui.kit.MajicDialog;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests where dialogs open. */
class DialogPlaceWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void placeTheWindow() {
        window.run(() -> window.frame.setBounds(0, 0, 1280, 800));
    }

    @Test
    void aDialogLeavesStopVisible() {
        assertThat(opened(window.frame, 1150, 650, false).intersects(stop())).isFalse();
    }

    @Test
    void aDialogOfADialogLeavesStopVisible() {
        List<Window> outer = new ArrayList<>();
        window.run(() -> outer.add(new MajicDialog(window.frame, "outer")));
        window.run(() -> outer.get(0).setBounds(0, 0, 1280, 800));
        assertThat(opened(outer.get(0), 1150, 650, false).intersects(stop())).isFalse();
    }

    @Test
    void aDialogWhoseContentScrollsFitsOntoTheScreenWithStop() {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        Rectangle dialog = opened(window.frame, 5000, 5000, true);
        assertThat(screen.contains(dialog)).isTrue();
        assertThat(dialog.intersects(stop())).isFalse();
    }

    private Rectangle opened(Window owner, int width, int height, boolean scrolls) {
        List<Rectangle> bounds = new ArrayList<>();
        window.run(() -> {
            LargeDialog dialog = new LargeDialog(owner, new Dimension(width, height), scrolls);
            bounds.add(dialog.getBounds());
            dialog.dispose();
        });
        return bounds.get(0);
    }

    private Rectangle stop() {
        JButton stop = window.awaitShowing("stop", JButton.class);
        return new Rectangle(stop.getLocationOnScreen(), stop.getSize());
    }

    private static final class LargeDialog extends MajicDialog {
        private static final long serialVersionUID = 1L;

        LargeDialog(Window owner, Dimension size, boolean scrolls) {
            super(owner, "large");
            JPanel content = new JPanel();
            content.setPreferredSize(size);
            if (scrolls) {
                canShrinkTo(300, 200);
            }
            fill(content, closing("Close"));
        }
    }
}

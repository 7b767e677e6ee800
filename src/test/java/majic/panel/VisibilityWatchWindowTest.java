package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Frame;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import majic.gui.kit.EventThreadChecks;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class VisibilityWatchWindowTest {
    @AutoClose
    private final EventThreadChecks checks = new EventThreadChecks();

    private final List<Boolean> reported = new ArrayList<>();
    private final JPanel panel = GuiActionRunner.execute(() -> new JPanel());
    private final VisibilityWatch watch = GuiActionRunner.execute(() -> new VisibilityWatch(panel, reported::add));
    private JTabbedPane tabs;
    private JFrame frame;

    @BeforeEach
    void open() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            tabs = new JTabbedPane();
            tabs.addTab("1", panel);
            tabs.addTab("2", new JPanel());
            frame = new JFrame();
            frame.add(tabs);
            frame.pack();
            frame.setVisible(true);
        });
        checks.windowIsOpen();
    }

    @AfterEach
    void close() throws Exception {
        SwingUtilities.invokeAndWait(frame::dispose);
    }

    @Test
    void aHiddenTabIsReportedAsHidden() throws Exception {
        SwingUtilities.invokeAndWait(() -> tabs.setSelectedIndex(1));
        SwingUtilities.invokeAndWait(() -> tabs.setSelectedIndex(0));

        assertThat(reported).containsExactly(true, false, true);
    }

    @Test
    void anIconIsReportedAsHidden() throws Exception {
        state(Frame.NORMAL, Frame.ICONIFIED);
        assertThat(reported).containsExactly(true, false);
        state(Frame.ICONIFIED, Frame.NORMAL);

        assertThat(reported).containsExactly(true, false, true);
    }

    @Test
    void aHiddenTabStaysHiddenWhenItsIconIsOpened() throws Exception {
        SwingUtilities.invokeAndWait(() -> tabs.setSelectedIndex(1));
        state(Frame.NORMAL, Frame.ICONIFIED);
        state(Frame.ICONIFIED, Frame.NORMAL);

        assertThat(reported).containsExactly(true, false);
    }

    @Test
    void whatLeftItsWindowIsReportedAsHidden() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            watch.end();
            tabs.remove(panel);
        });

        assertThat(reported).containsExactly(true, false);
    }

    private void state(int before, int now) throws Exception {
        SwingUtilities.invokeAndWait(
                () -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_STATE_CHANGED, before, now)));
    }
}

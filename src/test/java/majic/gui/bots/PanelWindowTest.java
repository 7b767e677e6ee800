package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.HierarchyEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import majic.gui.Contrast;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.gui.WindowAudit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the panel of a robot in a window of its own. */
class PanelWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private ToyBot one;

    @BeforeEach
    void openWindow() {
        one = window.add("one");
        window.add("two");
        window.push("window1");
        window.await("the window", () -> window.isShowing("robotWindow1"));
    }

    @Test
    void thePanelIsInItsOwnWindowAndTheMainWindowStatesIt() {
        assertThat(windowOfPanel().getName()).isEqualTo("robotWindow1");
        assertThat(window.text("elsewhere1")).isEqualTo("In a window of its own");
    }

    @Test
    void theButtonPutsThePanelBack() {
        window.push("window1");
        window.await("the window to go", () -> !window.isShowing("robotWindow1"));
        assertThat(windowOfPanel()).isSameAs(window.frame);
        assertThat(window.isShowing("bot1")).isTrue();
    }

    @Test
    void theOtherPanelsStayInTheMainWindowMeanwhile() {
        Component other = window.find("bot2", Component.class);
        AtomicInteger moves = new AtomicInteger();
        other.addHierarchyListener(event -> {
            if ((event.getChangeFlags() & HierarchyEvent.PARENT_CHANGED) != 0) {
                moves.incrementAndGet();
            }
        });
        window.push("window1");
        window.await("the window to go", () -> !window.isShowing("robotWindow1"));

        assertThat(moves).hasValue(0);
        assertThat(window.find("mainPane", JTabbedPane.class).indexOfComponent(other))
                .isEqualTo(1);
    }

    @Test
    void closingTheWindowPutsThePanelBack() {
        Window own = windowOfPanel();
        window.run(() -> own.dispatchEvent(new WindowEvent(own, WindowEvent.WINDOW_CLOSING)));
        window.await("the window to go", () -> !window.isShowing("robotWindow1"));
        assertThat(windowOfPanel()).isSameAs(window.frame);
    }

    @Test
    void theWindowClosesWhenTheRobotIsRemoved() {
        window.team.remove(1);
        window.await("the window to go", () -> !window.isShowing("robotWindow1"));
    }

    @Test
    void theStopKeysWorkInTheWindow() {
        window.focus("drivePad-window1");
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
        window.team.release();
        window.press(KeyEvent.VK_F12);
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void theStopButtonOfTheWindowStopsAllRobots() {
        window.click("smallStop");
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void thePadOfTheWindowDrivesItsRobotWhateverIsSelected() {
        window.click("tab2");
        window.focus("drivePad-window1");
        window.hold(KeyEvent.VK_UP);
        window.await("the drive", () -> one.told.contains("drive 200 0"));
        window.letGo(KeyEvent.VK_UP);
        window.await(
                "the robot to be stationary",
                () -> one.told.get(one.told.size() - 1).equals("halt"));
    }

    @Test
    void theMenuOfATabOpensTheWindowToo() {
        window.menuOf("tab2");
        window.click("openWindow");
        window.await("the window", () -> window.isShowing("robotWindow2"));
    }

    private Window windowOfPanel() {
        return SwingUtilities.getWindowAncestor(window.find("bot1", Component.class));
    }

    @Test
    void itsPartsHaveNamesAndReadableTexts() {
        Container root = windowOfPanel();
        window.run(() -> {
            assertThat(WindowAudit.nameless(root)).isEmpty();
            assertThat(WindowAudit.pale(root, Contrast.TEXT)).isEmpty();
        });
    }
}

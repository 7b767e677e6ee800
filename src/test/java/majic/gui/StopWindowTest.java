package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dialog;
import java.awt.event.KeyEvent;
import javax.swing.JButton;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Tag("jdk")
@Timeout(60)
class StopWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void theButtonHaltsEveryRobotAndLatches() {
        ToyBot one = window.add("one");
        ToyBot two = window.add("two");
        window.click("stop");
        window.await("both robots to halt", () -> one.told.contains("halt") && two.told.contains("halt"));
        assertThat(window.team.isLatched()).isTrue();
        window.await("the button to say so", () -> window.text("stopWord").equals("STOPPED"));
    }

    @Test
    void releaseAllowsMotionAgainAndHidesItself() {
        window.click("stop");
        window.click("release");
        assertThat(window.team.isLatched()).isFalse();
        window.await("the release button to go", () -> !window.isShowing("release"));
    }

    @Test
    void aLateEventDoesNotHideThatStopIsLatched() {
        window.click("stop");
        window.await("the button to say so", () -> window.text("stopWord").equals("STOPPED"));
        StopPanel panel = (StopPanel) window.find("stop", JButton.class).getParent();
        window.run(() -> panel.latchChanged(false));
        assertThat(window.text("stopWord")).isEqualTo("STOPPED");
    }

    @Test
    void escapeStopsWhileADialogHasTheFocus() {
        window.click("Add Bot");
        window.awaitDialog("Add Bot");
        window.focus("host");
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window.team::isLatched);
        assertThat(window.isShowing("Add Bot dialog")).isTrue();
    }

    @Test
    void f12StopsWhileTheCommandLineHasTheFocus() {
        window.focus("commandLine");
        window.press(KeyEvent.VK_F12);
        window.await("the latch", window.team::isLatched);
    }

    @Test
    void theButtonCanBeClickedWhileADialogIsOpen() {
        window.click("Help");
        Dialog help = window.awaitDialog("Help");
        window.run(() -> help.setLocation(0, 500));
        window.click("stop");
        window.await("the latch", window.team::isLatched);
    }
}

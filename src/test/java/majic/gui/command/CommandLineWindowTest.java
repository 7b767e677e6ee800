package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Component;
import java.awt.event.KeyEvent;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Tag("jdk")
@Timeout(60)
class CommandLineWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final ToyBot bot = window.add("one");

    @Test
    void aValidLineIsClearedAwayAndItsAnswerShown() {
        window.command("1 move 50");
        assertThat(window.text("commandLine")).isEmpty();
        window.awaitMessage("1 move 50: done");
        assertThat(bot.told).contains("move 50");
    }

    @Test
    void aWrongLineStaysWithItsMessageUntilItIsCorrected() {
        window.command("7 move 50");
        assertThat(window.text("commandLine")).isEqualTo("7 move 50");
        assertThat(window.text("hint")).contains("7").contains("no robot");
        window.type(" ");
        assertThat(window.text("hint")).doesNotContain("no robot");
    }

    @Test
    void arrowKeysWalkThroughEarlierLines() {
        window.command("1 move 10");
        window.command("1 move 20");
        window.press(KeyEvent.VK_UP);
        window.press(KeyEvent.VK_UP);
        assertThat(window.text("commandLine")).isEqualTo("1 move 10");
        window.press(KeyEvent.VK_DOWN);
        assertThat(window.text("commandLine")).isEqualTo("1 move 20");
    }

    @Test
    void aLineThatNamesABehaviourIsCheckedBesideTheWindow() {
        window.command("1 act Nowhere");
        window.await("the check", () -> window.text("hint").contains("there is no act Nowhere"));
        assertThat(window.text("commandLine")).isEqualTo("1 act Nowhere");
        window.focus("commandLine");
        window.type(" ");
        window.await("the line to be mended", () -> window.text("commandLine").equals("1 act Nowhere "));
    }

    @Test
    void anArrowKeyHeldFromDrivingRecallsNoLine() {
        window.command("1 move 10");
        window.focus("drivePad");
        arrow("drivePad", KeyEvent.KEY_PRESSED, 1000);
        window.focus("commandLine");
        arrow("commandLine", KeyEvent.KEY_RELEASED, 1500);
        arrow("commandLine", KeyEvent.KEY_PRESSED, 1501);
        assertThat(window.text("commandLine")).isEmpty();

        arrow("commandLine", KeyEvent.KEY_RELEASED, 1530);
        arrow("commandLine", KeyEvent.KEY_PRESSED, 1700);
        assertThat(window.text("commandLine")).isEqualTo("1 move 10");
    }

    /** Dispatches an event of the arrow key Up as the system does while the key repeats. */
    private void arrow(String name, int event, long whenMs) {
        Component component = window.find(name, Component.class);
        window.run(() -> component.dispatchEvent(
                new KeyEvent(component, event, whenMs, 0, KeyEvent.VK_UP, KeyEvent.CHAR_UNDEFINED)));
    }

    @Test
    void whatIsTypedIsKeptWhenTheLookChangesAndTheFocusReturns() {
        window.focus("commandLine");
        window.type("3 mov");
        window.run(FlatLaf::updateUI);
        window.focus("drivePad");
        window.focus("commandLine");
        window.type("e 50");
        assertThat(window.text("commandLine")).isEqualTo("3 move 50");
    }

    @Test
    void tabCompletesAParameter() {
        window.focus("commandLine");
        window.type("1 get cruiseT");
        window.press(KeyEvent.VK_TAB);
        assertThat(window.text("commandLine").strip()).isEqualTo("1 get cruiseTurn");
    }
}

package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

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
        window.await("the check", () -> window.text("hint").contains("there is no behaviour Nowhere"));
        assertThat(window.text("commandLine")).isEqualTo("1 act Nowhere");
        window.focus("commandLine");
        window.type(" ");
        window.await("the line to be mended", () -> window.text("commandLine").equals("1 act Nowhere "));
    }

    @Test
    void tabCompletesAParameter() {
        window.focus("commandLine");
        window.type("1 get cruiseT");
        window.press(KeyEvent.VK_TAB);
        assertThat(window.text("commandLine").strip()).isEqualTo("1 get cruiseTurn");
    }
}

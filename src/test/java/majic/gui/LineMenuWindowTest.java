package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The context menu of the command line. */
class LineMenuWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void addARobot() {
        window.add("one");
    }

    @Test
    void itCutsCopiesAndPastes() {
        window.focus("commandLine");
        window.type("1 move 50");
        window.menuOf("commandLine");
        window.click("selectAll");
        window.menuOf("commandLine");
        window.click("cut");
        assertThat(window.text("commandLine")).isEmpty();

        window.menuOf("commandLine");
        assertThat(window.isEnabled("copy")).isFalse();
        window.click("paste");
        assertThat(window.text("commandLine")).isEqualTo("1 move 50");
    }

    @Test
    void itRecallsAndSearchesEarlierCommands() {
        window.command("1 move 10");
        window.command("1 move 20");
        window.menuOf("commandLine");
        window.click("earlier");
        window.menuOf("commandLine");
        window.click("earlier");
        assertThat(window.text("commandLine")).isEqualTo("1 move 10");
        window.menuOf("commandLine");
        window.click("later");
        assertThat(window.text("commandLine")).isEqualTo("1 move 20");

        window.menuOf("commandLine");
        window.click("searchEarlier");
        window.await("the search", () -> window.text("hint").contains("Ctrl R: the next"));
    }

    @Test
    void escClosesItAndStopsNothing() {
        window.menuOf("commandLine");
        window.awaitShowing("paste", JMenuItem.class);
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the end of the menu", () -> !window.isShowing("paste"));
        assertThat(window.team.isLatched()).isFalse();
    }
}

package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.act.SlowActs;
import majic.gui.TestWindow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests lines whose files are read while further ones are typed, and lines of earlier windows. */
class CheckedLineWindowTest {
    @TempDir
    private Path folder;

    @Test
    void whatIsTypedWhileALineIsCheckedIsKeptAndTheRefusedLineIsOfferedByUp() throws IOException {
        SlowActs slow = SlowActs.in(folder);
        try (TestWindow window = TestWindow.open(slow.acts())) {
            window.add("one");
            window.command("1 act Slow");
            window.type("3 mov");
            slow.answer();
            window.await("the refusal", () -> window.text("hint").contains("code of its own"));
            window.type("e 50");
            assertThat(window.text("commandLine")).isEqualTo("3 move 50");
            window.press(KeyEvent.VK_ESCAPE);
            window.press(KeyEvent.VK_UP);
            assertThat(window.text("commandLine")).isEqualTo("1 act Slow");
            assertThat(window.text("hint")).contains("code of its own");
            window.press(KeyEvent.VK_DOWN);
            assertThat(window.text("commandLine")).isEqualTo("3 move 50");
        }
    }

    @Test
    void aLineTypedWithoutPauseBehindOneThatReturnsIsNotMixedWithIt() throws IOException {
        SlowActs slow = SlowActs.in(folder);
        try (TestWindow window = TestWindow.open(slow.acts())) {
            window.add("one");
            window.command("1 act Slow");
            slow.answer();
            window.await("the line to return", () -> window.text("commandLine").equals("1 act Slow"));
            window.typeAsOf(System.currentTimeMillis() - 500, "commandLine", '3');
            assertThat(window.text("commandLine")).isEqualTo("3");
        }
    }

    @Test
    void aLineThatIsRefusedAfterEscIsNotMarkedSoThatTheNextEscStops() throws IOException {
        SlowActs slow = SlowActs.in(folder);
        try (TestWindow window = TestWindow.open(slow.acts())) {
            window.add("one");
            window.command("1 act Slow");
            window.press(KeyEvent.VK_ESCAPE);
            window.await("the stop", window::isStopLatched);
            window.team.release();
            slow.answer();
            window.await("the refusal", () -> window.text("hint").contains("code of its own"));
            window.press(KeyEvent.VK_ESCAPE);
            window.await("the stop", window::isStopLatched);
            window.press(KeyEvent.VK_UP);
            assertThat(window.text("commandLine")).isEqualTo("1 act Slow");
        }
    }

    @Test
    void theLinesOfAnEarlierWindowAreRecalled() throws IOException {
        Path file = folder.resolve("history");
        try (TestWindow window = TestWindow.withHistory(file)) {
            window.command("bots");
            window.await("the file", () -> Files.exists(file) && file.toFile().length() == 5);
        }
        try (TestWindow window = TestWindow.withHistory(file)) {
            window.focus("commandLine");
            window.await("the earlier line", () -> {
                window.press(KeyEvent.VK_UP);
                return window.text("commandLine").equals("bots");
            });
        }
    }
}

package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import majic.act.SlowActs;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the window while a file that a typed line names is being checked. */
class SlowFileWindowTest {
    @TempDir
    private Path folder;

    private SlowActs slow;
    private TestWindow window;

    @BeforeEach
    void typeALineThatIsChecked() throws Exception {
        slow = SlowActs.in(folder);
        window = TestWindow.open(slow.acts());
        window.add("one");
        window.command("1 act Slow");
        slow.awaitCheck();
    }

    @AfterEach
    void close() throws IOException {
        slow.answer();
        window.close();
    }

    @Test
    void theKeysTypedMeanwhileAreKeptInTheirOrder() {
        window.type("3 move 50");
        assertThat(window.text("commandLine")).isEqualTo("3 move 50");
        slow.answer();
        window.awaitMessage("it brings code of its own");
        assertThat(window.text("commandLine")).isEqualTo("3 move 50");
    }

    @Test
    void aStopTypedMeanwhileIsTakenAtOnce() {
        window.command("stop");
        assertThat(window.team.isLatched()).isTrue();
    }

    @Test
    void aRefusedLineReturnsForCorrection() {
        slow.answer();
        window.await("the line", () -> window.text("commandLine").equals("1 act Slow"));
        assertThat(window.text("hint")).contains("it brings code of its own");
    }
}

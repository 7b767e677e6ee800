package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.FakeBot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** When a behaviour in MAJIC Script ends, all it has ordered ends with it, on each of its robots. */
@Timeout(30)
class ActEndTest {
    /** Robot 1 is told again and again to drive, for half a minute. */
    private static final String LONG_DRIVE = "1 drive 100 0 for 30s";

    @TempDir
    private Path folder;

    private final Desk desk = Desk.withTwo();
    private FakeBot driver;

    @BeforeEach
    void name() {
        driver = desk.bot(1);
    }

    @AfterEach
    void close() {
        desk.close();
    }

    private String file(String... lines) throws IOException {
        Path path = Files.write(folder.resolve("both.majic"), List.of(lines));
        return '"' + path.toString() + '"';
    }

    private void assertThatItStands() throws InterruptedException {
        int sent = driver.sent().size();
        desk.pause(5);
        assertThat(driver.sent()).hasSize(sent).endsWith("halt");
    }

    @Test
    void byAFailureOfOneTheOthersStand() throws Exception {
        desk.bot(2).stallAfter(200);
        desk.runPipe("1 act " + file(LONG_DRIVE, "2 move 400", "wait") + " with 2");
        assertThatItStands();
    }

    @Test
    void byAStopOfOneTheOthersStand() throws Exception {
        desk.prompt.parseText("1 act " + file(LONG_DRIVE, "2 move 5000", "wait") + " with 2");
        desk.pause(1);
        desk.prompt.parseText("2 stop");
        desk.prompt.awaitAll();
        assertThatItStands();
    }

    @Test
    void calledOffItsRobotsStand() throws Exception {
        desk.prompt.parseText("1 act " + file(LONG_DRIVE, "2 move 5000", "wait") + " with 2");
        desk.pause(1);
        desk.prompt.parseText("2 act off");
        desk.prompt.awaitAll();
        assertThatItStands();
    }

    @Test
    void calledOffBeforeItsTurnItNeverBegins() throws Exception {
        String drive = file("me move 5000");
        assertThat(desk.runPipe("1 move 300", "1 act " + drive, "1 act off", "1 turn 90"))
                .contains("1 act off: no behaviour runs on it", "1 act " + drive + ": stopped");
        assertThat(driver.sent()).containsSubsequence("move 300", "turn 90").doesNotContain("move 5000");
    }

    @Test
    void itsOwnStopEndsNothingThatSomebodyElseOrdered() throws Exception {
        String stops = file("me drive 100 0 for 30s", "wait 1s", "me stop", "me move 50");
        assertThat(desk.runPipe("repeat 2", "1 act " + stops, "1 turn 90", "end"))
                .noneMatch(line -> line.contains("not run") || line.contains("failed"))
                .contains("1 drive 100 0 for 30s: stopped");
        assertThat(driver.sent()).containsSubsequence("move 50", "turn 90", "move 50", "turn 90");
    }
}

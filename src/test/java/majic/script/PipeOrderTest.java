package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** In a pipe, at a socket and in a file, what a line needs of the lines before it is done by then. */
class PipeOrderTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    private String endless() throws IOException {
        return Files.write(folder.resolve("endless.majic"), List.of("repeat", "me move 300", "end"))
                .toString();
    }

    private void assertThatItMovedAfterwards() {
        assertThat(fixture.answers())
                .contains("2 move 20: done (20 mm, 0.1 s)")
                .noneMatch(line -> line.contains("is running"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"2 act off", "2 stop", "all act off"})
    void aRobotIsFreeForTheLineBehindTheOneThatEndedItsAct(String end) throws Exception {
        for (int round = 0; round < 10; round++) {
            fixture.runPipe("2 act " + endless(), "wait 1s", end, "2 move 20");
            assertThatItMovedAfterwards();
        }
    }

    @Test
    void afterStopAndReleaseARobotIsFree() throws Exception {
        fixture.runPipe("2 act " + endless(), "wait 1s", "all stop", "release", "2 move 20");
        assertThatItMovedAfterwards();
    }

    @ParameterizedTest
    @ValueSource(strings = {"2 act off", "2 stop"})
    void theSameOverASocket(String end) throws Exception {
        MajicParser socket = MajicParser.socket(fixture.session);
        for (String line : List.of("2 act " + endless(), "wait 1s")) {
            socket.parseText(line);
        }
        fixture.pause(1.5);
        socket.parseText(end);
        socket.parseText("2 move 20");
        socket.awaitAll();
        assertThatItMovedAfterwards();
    }

    @Test
    void aStopWaitsUntilAScriptOfAnotherSourceHasReleasedItsRobots() throws Exception {
        for (String line : List.of("repeat", "2 move 100", "2 wait", "end")) {
            fixture.prompt.parseText(line);
        }
        fixture.pause(1);
        fixture.runPipe("2 stop", "2 move 20");
        assertThatItMovedAfterwards();
    }

    @Test
    void theParameterLogIsSavedAfterTheLogLinesBeforeIt() throws Exception {
        Path file = folder.resolve("l.csv");
        fixture.runPipe("2 log x every 100ms", "2 move 300", "2 log off", "save log " + file);
        assertThat(Files.readAllLines(file)).hasSizeGreaterThan(8);
    }

    @Test
    void aSessionThatWasSavedCanBeRunByTheNextLine() throws Exception {
        Path file = folder.resolve("s.majic");
        fixture.runPipe("add sim:aibo as 3", "3 move 30", "save session " + file, "run " + file);
        assertThat(fixture.pipe.allSucceeded()).as(fixture.answers().toString()).isTrue();
        assertThat(fixture.bot(3).sent()).containsExactly("move 30", "move 30");
    }

    @Test
    void theSameInAFile() throws Exception {
        Path saved = folder.resolve("s.majic");
        Path script = Files.write(
                folder.resolve("both.majic"), List.of("1 move 30", "save session " + saved, "run " + saved));
        fixture.runPipe("run " + script);
        assertThat(fixture.pipe.allSucceeded()).as(fixture.answers().toString()).isTrue();
    }

    @Test
    void aRefusalNamesItsLineAlsoIfTheLineHadToWait() throws Exception {
        fixture.pipe.parseLine(1, "1 move 300");
        fixture.pipe.parseLine(2, "add sim:aibo as 3");
        fixture.pipe.parseLine(3, "7 move 100");
        fixture.pipe.parseLine(4, "run nowhere.majic");
        fixture.pipe.awaitAll();
        assertThat(fixture.answers())
                .anyMatch(line -> line.startsWith("line 3: 7: there is no robot 7"))
                .anyMatch(line -> line.startsWith("line 4: nowhere.majic: "));
    }
}

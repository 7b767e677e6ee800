package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Scripts in files and blocks at the prompt: they have their robots to themselves, and end with all of them. */
class ScriptsTest {
    @TempDir
    Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    private String file(String... lines) throws IOException {
        Path file = folder.resolve("test.majic");
        Files.write(file, List.of(lines));
        return file.toString();
    }

    private void type(String... lines) {
        for (String line : lines) {
            assertThat(fixture.prompt.parseText(line)).isEmpty();
        }
    }

    @Test
    void aFileRunsToItsEndAndWaitsForItsRobots() throws Exception {
        String file = file("# a square", "repeat 2", "  1 move 300", "  1 turn 90", "end", "2 move 30");
        assertThat(fixture.runPipe("run " + file, "2 get x"))
                .containsSubsequence(
                        "1 turn 90: done (90 deg, 1.0 s)", "run " + file + ": done (4.0 s)", "2 x = 30 mm");
        assertThat(fixture.bot(1).sent()).containsExactly("move 300", "turn 90", "move 300", "turn 90");
    }

    @Test
    void aFileWithABlankInItsNameIsAnsweredInQuotes() throws Exception {
        Path file = folder.resolve("a square.majic");
        Files.write(file, List.of("1 move 30"));
        assertThat(fixture.runPipe("run \"" + file + "\""))
                .anyMatch(line -> line.startsWith("run \"" + file + "\": done ("));
    }

    @Test
    void aLimitThatIsRaisedInAFileHoldsForItsMoves() throws Exception {
        String file = file("1 set maxMove 10m", "1 move 6m");
        assertThat(fixture.runPipe("run " + file)).anyMatch(line -> line.startsWith("1 move 6m: done ("));
    }

    @Test
    void allMistakesAreReportedTogetherAndNothingRuns() throws Exception {
        String file =
                file("1 move 30", "1 mvoe 3", "", "while 1 bumpd == no", "  2 move", "end", "9 move 3", "1 move 5 5");
        fixture.runPipe("run " + file);
        assertThat(fixture.answers())
                .containsExactly(
                        file + ":2:3: mvoe: robot 1 (Aibo) has no such command; did you mean move?",
                        file + ":4:9: bumpd: robot 1 (Aibo) has no such parameter; did you mean bumped?",
                        file + ":5:9: behind \"move\" a distance (mm, cm, m) is missing",
                        file + ":7:1: 9: there is no robot 9 (robots: 1 Aibo, 2 Pioneer)",
                        file + ":8:10: 5: nothing more is expected behind \"1 move 5\"",
                        "run " + file + ": failed: 5 mistakes in it, nothing was run");
        assertThat(fixture.bot(1).sent()).isEmpty();
        assertThat(fixture.pipe.allSucceeded()).isFalse();
    }

    @Test
    void ofVeryManyMistakesTheFirstAreReportedAndTheOthersCounted() throws Exception {
        Path wrong = Files.write(folder.resolve("wrong.majic"), Collections.nCopies(5000, "1 mvoe 5"));
        assertThat(fixture.runPipe("run " + wrong))
                .hasSize(22)
                .startsWith(wrong + ":1:3: mvoe: robot 1 (Aibo) has no such command; did you mean move?")
                .endsWith(
                        wrong + ": and 4980 more mistakes",
                        "run " + wrong + ": failed: 5000 mistakes in it, nothing was run");
    }

    @Test
    void whatTheRobotsCannotDoIsFoundBeforeAnythingRuns() throws Exception {
        String file = file("1 move 30", "1 mvoe 3", "while 1 bumpd == no", "  2 set x 3", "end", "9 move 3");
        fixture.runPipe("run " + file);
        assertThat(fixture.answers())
                .containsExactly(
                        file + ":2:3: mvoe: robot 1 (Aibo) has no such command; did you mean move?",
                        file + ":3:9: bumpd: robot 1 (Aibo) has no such parameter; did you mean bumped?",
                        file + ":4:9: x: can be read but not set",
                        file + ":6:1: 9: there is no robot 9 (robots: 1 Aibo, 2 Pioneer)",
                        "run " + file + ": failed: 4 mistakes in it, nothing was run");
        assertThat(fixture.bot(1).sent()).isEmpty();
    }

    @Test
    void robotsAddedInAFileAreCheckedWhenTheirLineComes() throws Exception {
        String file = file("add sim:aibo as 7", "7 move 30", "7 get nothing");
        fixture.runPipe("run " + file);
        assertThat(fixture.answers())
                .contains(
                        "7: Aibo at sim:aibo connected",
                        file + ":3:7: nothing: robot 7 (Aibo) has no such parameter",
                        "run " + file + ": failed: line 3");
    }

    @Test
    void blocksThatAreNotClosedAreNamed() throws Exception {
        String file = file("repeat 3", "1 move 3", "if 1 bumped == no", "end");
        fixture.runPipe("run " + file);
        assertThat(fixture.answers()).contains(file + ":1:1: repeat: its \"end\" is missing");
    }

    @Test
    void aScriptOwnsItsRobots() throws Exception {
        type("run " + file("repeat", "1 move 300", "1 wait", "end"));
        fixture.pause(0.5);
        assertThat(fixture.prompt.parseText("1 move 30")).hasValue("1 is running test.majic; \"1 stop\" ends it");
        assertThat(fixture.prompt.parseText("1 set headPan 3")).isPresent();
        assertThat(fixture.prompt.parseText("1 set light on")).isEmpty();
        assertThat(fixture.prompt.parseText("2 move 30")).isEmpty();
        type("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).anyMatch(line -> line.endsWith("test.majic: stopped"));
        type("1 move 30");
    }

    @Test
    void aFailureEndsTheScriptAndStopsEveryRobotItUsed() throws Exception {
        fixture.bot(1).stallAfter(120);
        String file = file("2 move 3m", "1 move 300", "1 move 30", "1 get x");
        fixture.runPipe("run " + file, "2 get x");
        assertThat(fixture.answers())
                .contains(
                        "1 move 300: failed: stalled after 120 mm",
                        "1 move 30: not run: 1 move 300 failed",
                        "2 move 3m: stopped",
                        "2 stop: done",
                        "run " + file + ": failed: 1 move 300 failed");
        assertThat(fixture.pipe.allSucceeded()).isFalse();
    }

    @Test
    void aScriptMayStopItsOwnRobotsAndGoOn() throws Exception {
        String file = file("1,2 move 3m", "wait 1s", "1 stop", "1 turn 90", "2 wait");
        assertThat(fixture.runPipe("run " + file))
                .contains("1 move 3m: stopped", "1 turn 90: done (90 deg, 1.0 s)", "run " + file + ": done (10.0 s)");
        assertThat(fixture.pipe.allSucceeded()).isTrue();
    }

    @Test
    void stopForAllEndsTheScriptThatContainsIt() throws Exception {
        String file = file("1 move 3m", "wait 1s", "all stop", "2 move 30");
        assertThat(fixture.runPipe("run " + file)).contains("1 move 3m: stopped", "run " + file + ": stopped");
        assertThat(fixture.bot(2).sent()).doesNotContain("move 30");
        assertThat(fixture.team.isLatched()).isTrue();
    }

    @Test
    void anUndecidedConditionEndsTheScript() throws Exception {
        fixture.bot(2).cut();
        fixture.runPipe("if 2 distanceFront < 30", "1 move 30", "end");
        assertThat(fixture.answers())
                .endsWith("if 2 distanceFront < 30: failed: if 2 distanceFront < 30 is undecided: "
                        + "2 distanceFront is unknown (connection lost)");
    }

    @Test
    void filesMayRunFilesButNotThemselvesForEver() throws Exception {
        Path file = folder.resolve("test.majic");
        String self = file("1 get now x", "run " + file);
        fixture.runPipe("run " + self);
        assertThat(fixture.answers())
                .contains("run " + self + ": failed: " + self + ": files run each other too deeply");
    }

    @Test
    void aTypedBlockRunsBesideOtherLines() throws Exception {
        type("repeat 2", "1 move 300", "1 turn 90", "end", "2 move 30");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers())
                .containsSubsequence("2 move 30: done (30 mm, 0.1 s)", "1 turn 90: done (90 deg, 1.0 s)")
                .endsWith("repeat 2: done (4.0 s)");
    }

    @Test
    void aWrongLineOfATypedBlockIsRefusedAndTheBlockStaysOpen() throws Exception {
        type("repeat 2");
        assertThat(fixture.prompt.parseText("1 mvoe 300")).isPresent();
        assertThat(fixture.prompt.isBlockOpen()).isTrue();
        type("1 move 30", "end");
        fixture.prompt.awaitAll();
        assertThat(fixture.bot(1).sent()).containsExactly("move 30", "move 30");
    }

    @Test
    void aBlockThatIsNotClosedAtTheEndOfAPipeIsNotRun() throws Exception {
        assertThat(fixture.runPipe("repeat 2", "1 move 30"))
                .containsExactly("the \"end\" of the last block is missing; nothing of it was run");
        assertThat(fixture.pipe.allSucceeded()).isFalse();
    }

    @Test
    void anIdleLoopLetsTheClockGoOnAndCanBeStopped() throws Exception {
        type("repeat", "1 get now x", "end");
        fixture.pause(0.055);
        type("stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).filteredOn("1 x = 0 mm"::equals).hasSizeBetween(5, 8);
    }

    @Test
    void aMissingOrHugeFileIsRefused() throws Exception {
        Path huge = folder.resolve("huge.majic");
        Files.writeString(huge, "#\n".repeat(600_000));
        fixture.runPipe("run " + huge, "run " + folder);
        assertThat(fixture.answers())
                .anyMatch(line -> line.endsWith(folder + ": not a file with a script"))
                .anyMatch(line -> line.endsWith(huge + ": too long for a script, more than 1000000 bytes"));
    }
}

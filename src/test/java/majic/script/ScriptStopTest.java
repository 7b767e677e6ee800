package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** STOP, and the stop of one robot. */
class ScriptStopTest {
    private static final String LATCHED = "STOP is latched; \"release\" allows motion again";

    private static final int ROUNDS = 200;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @ParameterizedTest
    @ValueSource(
            strings = {
                "stop",
                "stop all",
                "all stop",
                "ALL.STOP()",
                "1 sotp stop",
                "stop!",
                "7 stop",
                "\"stop",
                "1 move stop",
                "stop 1"
            })
    void stopsEveryRobotAndLatches(String line) throws InterruptedException {
        fixture.prompt.parseText("1,2 move 3m");
        fixture.pause(0.5);
        fixture.prompt.parseText(line);
        fixture.prompt.awaitAll();
        assertThat(fixture.answers())
                .contains("1 move 3m: stopped", "2 move 3m: stopped", "1 stop: done", "2 stop: done", LATCHED);
        assertThat(fixture.prompt.parseText("1 move 30")).hasValue(LATCHED);
    }

    /** The thread of a block may begin before or after the stop, so it is typed often. */
    @Test
    void aBlockThatWasTypedBeforeAStopEnds() throws InterruptedException {
        for (int round = 0; round < ROUNDS; round++) {
            List.of("repeat", "1 get x", "end", "stop").forEach(fixture.prompt::parseText);
            fixture.prompt.awaitAll();
            fixture.prompt.parseText("release");
        }
        assertThat(fixture.answers()).contains("1 stop: done");
    }

    @ParameterizedTest
    @ValueSource(strings = {"stop", "1 stopp stop"})
    void withoutARobotDoesNotLatch(String line) throws InterruptedException {
        fixture.team.remove(1);
        fixture.team.remove(2);
        fixture.prompt.parseText(line);
        fixture.prompt.awaitAll();
        assertThat(fixture.team.isLatched()).isFalse();
    }

    @Test
    void withoutARobotIsAnsweredWithTheReason() throws InterruptedException {
        fixture.team.remove(1);
        fixture.team.remove(2);
        fixture.prompt.parseText("stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("stop: there is no robot to stop");
    }

    @Test
    void isReportedAsTakenAsStop() {
        assertThat(fixture.prompt.parseText("1 stopp stop"))
                .hasValue("taken as STOP: stopp: robot 1 (Aibo) has no such command; did you mean stop?");
    }

    @Test
    void releaseAllowsMotionAgainAndResumesNothing() throws InterruptedException {
        fixture.prompt.parseText("1 move 3m");
        fixture.prompt.parseText("1 move 1m");
        fixture.prompt.parseText("stop");
        fixture.prompt.parseText("release");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("1 move 1m: not run: stopped");
        assertThat(fixture.runPipe("1 move 30")).contains("1 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void ofOneRobotLeavesTheOthersAlone() throws InterruptedException {
        fixture.prompt.parseText("1,2 move 300");
        fixture.pause(0.5);
        fixture.prompt.parseText("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers())
                .contains("1 move 300: stopped", "1 stop: done", "2 move 300: done (300 mm, 1.0 s)");
        assertThat(fixture.team.isLatched()).isFalse();
    }

    @Test
    void overtakesATypedWaitAndDropsTheLinesBehindIt() throws InterruptedException {
        fixture.prompt.parseText("1 move 3m");
        fixture.prompt.parseText("wait");
        fixture.prompt.parseText("2 move 100");
        fixture.pause(0.1);
        fixture.prompt.parseText("stop");
        fixture.prompt.parseText("release");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("wait: stopped", "2 move 100: not run: stopped");
        assertThat(fixture.bot(2).sent()).doesNotContain("move 100");
    }

    @Test
    void ofOneRobotDropsOnlyItsWaitingLines() throws InterruptedException {
        for (String line : new String[] {"1 move 3m", "wait", "1 turn 90", "2 move 100"}) {
            fixture.prompt.parseText(line);
        }
        fixture.pause(0.1);
        fixture.prompt.parseText("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("1 turn 90: not run: stopped", "2 move 100: done (100 mm, 0.3 s)");
    }

    @Test
    void ofOneRobotInAPipeLetsItsNextLinesRun() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 3m", "wait 1s", "1 stop", "1 turn 90"))
                .contains("1 move 3m: stopped", "1 turn 90: done (90 deg, 1.0 s)");
        assertThat(fixture.pipe.allSucceeded()).isTrue();
    }

    @Test
    void takesItsTurnInAPipe() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 3m", "wait 1s", "all stop", "release", "1 turn 90", "wait", "quit"))
                .contains("1 move 3m: stopped", "1 turn 90: done (90 deg, 1.0 s)");
        assertThat(fixture.quits).hasValue(1);
        assertThat(fixture.pipe.allSucceeded()).isTrue();
    }

    @Test
    void isNeverDelayedForAProgramAtASocket() throws InterruptedException {
        MajicParser socket = MajicParser.socket(fixture.session);
        socket.parseText("1 move 3m");
        socket.parseText("wait");
        fixture.pause(0.1);
        socket.parseText("1 stop");
        socket.awaitAll();
        assertThat(fixture.answers()).contains("1 move 3m: stopped");
    }

    @Test
    void aloneOnALineEndsABlockThatIsBeingTyped() {
        fixture.prompt.parseText("repeat");
        fixture.prompt.parseText("1 move 100");
        assertThat(fixture.prompt.isBlockOpen()).isTrue();
        fixture.prompt.parseText("stop");
        assertThat(fixture.team.isLatched()).isTrue();
        assertThat(fixture.prompt.isBlockOpen()).isFalse();
    }

    @Test
    void forAllMayBePartOfABlock() throws InterruptedException {
        for (String line : new String[] {"if 1 bumped == no", "all stop", "end"}) {
            assertThat(fixture.prompt.parseText(line)).isEmpty();
        }
        fixture.prompt.awaitAll();
        assertThat(fixture.team.isLatched()).isTrue();
    }

    @Test
    void byAButtonDropsWaitingLinesAsWell() throws InterruptedException {
        for (String line : new String[] {"1 move 3m", "wait", "1 turn 90", "2 move 100"}) {
            fixture.prompt.parseText(line);
        }
        fixture.pause(0.1);
        fixture.team.stop(List.of(fixture.team.member(1)), null);
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("1 turn 90: not run: stopped", "2 move 100: done (100 mm, 0.3 s)");
    }

    @Test
    void isTakenAsStopAfterAnyError() {
        fixture.prompt.parseText("1 move 3m");
        fixture.aibo.breakDown();
        assertThat(fixture.prompt.parseText("aibo stop"))
                .get()
                .asString()
                .startsWith("taken as STOP: an error in MAJIC");
        assertThat(fixture.team.isLatched()).isTrue();
    }

    /** The type in the condition is looked up by the check (1) and by the submission (2) of the line. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void revokesALineThatIsChecked(int lookup) throws InterruptedException {
        fixture.aibo.duringName(lookup, () -> fixture.team.stop(List.of(fixture.team.member(1)), null));
        fixture.prompt.parseText("1 move 1m until aibo bumped == yes");
        fixture.prompt.awaitAll();
        assertThat(fixture.bot(1).sent()).doesNotContain("move 1000");
        assertThat(fixture.answers()).contains("1 move 1m until aibo bumped == yes: not run: stopped");
    }

    /** As above; a line that waited is checked again (2) before its submission (3). */
    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void revokesALineWhoseTurnHasCome(int lookup) throws InterruptedException {
        fixture.aibo.duringName(lookup, () -> fixture.team.stop(List.of(fixture.team.member(1)), null));
        fixture.prompt.parseText("wait 1s");
        fixture.prompt.parseText("1 move 1m until aibo bumped == yes");
        fixture.prompt.awaitAll();
        assertThat(fixture.bot(1).sent()).doesNotContain("move 1000");
        assertThat(fixture.answers()).contains("1 move 1m until aibo bumped == yes: not run: stopped");
    }

    /** The type is looked up as the block is checked (3) and as it takes its robots (4). */
    @ParameterizedTest
    @ValueSource(ints = {3, 4})
    void endsABlockThatHasNotTakenItsRobots(int lookup) throws InterruptedException {
        fixture.aibo.duringName(lookup, () -> fixture.team.stop(List.of(fixture.team.member(1)), null));
        for (String line : new String[] {"repeat 1", "aibo move 1m", "end"}) {
            fixture.prompt.parseText(line);
        }
        fixture.prompt.awaitAll();
        assertThat(fixture.bot(1).sent()).doesNotContain("move 1000");
        assertThat(fixture.answers().toString()).contains("stopped").doesNotContain("done (");
    }

    /**
     * The further robot is looked up by the check of the line (2), by the check of the behaviour (3, 4), by its
     * submission (5) and when the robots are claimed for a script (6).
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6})
    void ofAFurtherRobotPreventsTheBehaviour(int lookup, @TempDir Path folder) throws Exception {
        Path both = Files.write(folder.resolve("both.majic"), List.of("2 move 1m", "1 move 1m"));
        fixture.aibo.duringName(lookup, () -> fixture.team.stop(List.of(fixture.team.member(1)), null));
        fixture.prompt.parseText("2 act \"" + both + "\" with aibo");
        fixture.prompt.awaitAll();
        assertThat(fixture.bot(1).sent()).doesNotContain("move 1000");
        assertThat(fixture.bot(2).sent()).doesNotContain("move 1000");
        assertThat(fixture.answers()).contains("2 act \"" + both + "\" with aibo: not run: stopped");
    }

    @Test
    void ofAFurtherRobotDropsABehaviourThatWaits(@TempDir Path folder) throws Exception {
        Path both = Files.write(folder.resolve("both.majic"), List.of("2 move 1m", "1 move 1m"));
        String line = "2 act \"" + both + "\" with 1";
        fixture.prompt.parseText("wait 1s");
        fixture.prompt.parseText(line);
        fixture.prompt.parseText("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains(line + ": not run: stopped");
        assertThat(fixture.bot(2).sent()).doesNotContain("move 1000");
    }

    @Test
    void ofAFurtherRobotEndsABlockThatCommandsIt(@TempDir Path folder) throws Exception {
        Path both = Files.write(folder.resolve("both.majic"), List.of("2 move 1m", "1 move 1m"));
        for (String line : new String[] {"repeat 1", "wait 1s", "2 act \"" + both + "\" with 1", "end"}) {
            fixture.prompt.parseText(line);
        }
        fixture.pause(0.5);
        fixture.prompt.parseText("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("repeat 1: stopped");
        assertThat(fixture.bot(2).sent()).doesNotContain("move 1000");
    }
}

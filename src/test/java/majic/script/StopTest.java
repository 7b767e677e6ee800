package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** STOP, and the stop of one robot. */
@Timeout(30)
class StopTest {
    private static final String LATCHED = "STOP is latched; \"release\" allows motion again";

    @AutoClose
    private final Desk desk = Desk.withTwo();

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
        desk.prompt.parseText("1,2 move 3m");
        desk.pause(0.5);
        desk.prompt.parseText(line);
        desk.prompt.awaitAll();
        assertThat(desk.said())
                .contains("1 move 3m: stopped", "2 move 3m: stopped", "1 stop: done", "2 stop: done", LATCHED);
        assertThat(desk.prompt.parseText("1 move 30")).hasValue(LATCHED);
    }

    @Test
    void isSaidToBeTakenAsSuch() {
        assertThat(desk.prompt.parseText("1 stopp stop"))
                .hasValue("taken as STOP: stopp: robot 1 (Aibo) has no such command; did you mean stop?");
    }

    @Test
    void releaseAllowsMotionAgainAndResumesNothing() throws InterruptedException {
        desk.prompt.parseText("1 move 3m");
        desk.prompt.parseText("1 move 1m");
        desk.prompt.parseText("stop");
        desk.prompt.parseText("release");
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains("1 move 1m: not run: stopped");
        assertThat(desk.runPipe("1 move 30")).contains("1 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void ofOneRobotLeavesTheOthersAlone() throws InterruptedException {
        desk.prompt.parseText("1,2 move 300");
        desk.pause(0.5);
        desk.prompt.parseText("1 stop");
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains("1 move 300: stopped", "1 stop: done", "2 move 300: done (300 mm, 1.0 s)");
        assertThat(desk.team.isLatched()).isFalse();
    }

    @Test
    void overtakesATypedWaitAndDropsWhatItHeld() throws InterruptedException {
        desk.prompt.parseText("1 move 3m");
        desk.prompt.parseText("wait");
        desk.prompt.parseText("2 move 100");
        desk.pause(0.1);
        desk.prompt.parseText("stop");
        desk.prompt.parseText("release");
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains("wait: stopped", "2 move 100: not run: stopped");
        assertThat(desk.bot(2).sent()).doesNotContain("move 100");
    }

    @Test
    void ofOneRobotDropsWhatIsHeldForItAlone() throws InterruptedException {
        for (String line : new String[] {"1 move 3m", "wait", "1 turn 90", "2 move 100"}) {
            desk.prompt.parseText(line);
        }
        desk.pause(0.1);
        desk.prompt.parseText("1 stop");
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains("1 turn 90: not run: stopped", "2 move 100: done (100 mm, 0.3 s)");
    }

    @Test
    void ofOneRobotInAPipeLetsItsNextLinesRun() throws InterruptedException {
        assertThat(desk.runPipe("1 move 3m", "wait 1s", "1 stop", "1 turn 90"))
                .contains("1 move 3m: stopped", "1 turn 90: done (90 deg, 1.0 s)");
        assertThat(desk.pipe.allSucceeded()).isTrue();
    }

    @Test
    void takesItsTurnInAPipe() throws InterruptedException {
        assertThat(desk.runPipe("1 move 3m", "wait 1s", "all stop", "release", "1 turn 90", "wait", "quit"))
                .contains("1 move 3m: stopped", "1 turn 90: done (90 deg, 1.0 s)");
        assertThat(desk.quits).hasValue(1);
        assertThat(desk.pipe.allSucceeded()).isTrue();
    }

    @Test
    void isNeverHeldForAProgramAtASocket() throws InterruptedException {
        MajicParser socket = MajicParser.remote(desk.session);
        socket.parseText("1 move 3m");
        socket.parseText("wait");
        desk.pause(0.1);
        socket.parseText("1 stop");
        socket.awaitAll();
        assertThat(desk.said()).contains("1 move 3m: stopped");
    }

    @Test
    void aloneOnALineEndsABlockThatIsBeingTyped() {
        desk.prompt.parseText("repeat");
        desk.prompt.parseText("1 move 100");
        assertThat(desk.prompt.isBlockOpen()).isTrue();
        desk.prompt.parseText("stop");
        assertThat(desk.team.isLatched()).isTrue();
        assertThat(desk.prompt.isBlockOpen()).isFalse();
    }

    @Test
    void forAllMayBePartOfABlock() throws InterruptedException {
        for (String line : new String[] {"if 1 bumped == no", "all stop", "end"}) {
            assertThat(desk.prompt.parseText(line)).isEmpty();
        }
        desk.prompt.awaitAll();
        assertThat(desk.team.isLatched()).isTrue();
    }

    @Test
    void byAButtonDropsWhatIsHeldAsWell() throws InterruptedException {
        for (String line : new String[] {"1 move 3m", "wait", "1 turn 90", "2 move 100"}) {
            desk.prompt.parseText(line);
        }
        desk.pause(0.1);
        desk.team.stop(List.of(desk.team.member(1)), null);
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains("1 turn 90: not run: stopped", "2 move 100: done (100 mm, 0.3 s)");
    }

    @Test
    void isTakenAsSuchWhateverBreaksDown() {
        desk.prompt.parseText("1 move 3m");
        desk.aibo.breakDown();
        assertThat(desk.prompt.parseText("aibo stop")).get().asString().startsWith("taken as STOP: an error in MAJIC");
        assertThat(desk.team.isLatched()).isTrue();
    }

    /** The type in the condition is looked up by the check (1) and by the submission (2) of the line. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void revokesALineThatIsChecked(int lookup) throws InterruptedException {
        desk.aibo.duringName(lookup, () -> desk.team.stop(List.of(desk.team.member(1)), null));
        desk.prompt.parseText("1 move 1m until aibo bumped == yes");
        desk.prompt.awaitAll();
        assertThat(desk.bot(1).sent()).doesNotContain("move 1000");
        assertThat(desk.said()).contains("1 move 1m until aibo bumped == yes: not run: stopped");
    }

    /** As above; a line that waited is checked again (2) before its submission (3). */
    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void revokesALineWhoseTurnHasCome(int lookup) throws InterruptedException {
        desk.aibo.duringName(lookup, () -> desk.team.stop(List.of(desk.team.member(1)), null));
        desk.prompt.parseText("wait 1s");
        desk.prompt.parseText("1 move 1m until aibo bumped == yes");
        desk.prompt.awaitAll();
        assertThat(desk.bot(1).sent()).doesNotContain("move 1000");
        assertThat(desk.said()).contains("1 move 1m until aibo bumped == yes: not run: stopped");
    }

    /** The type is looked up as the block is checked (3) and as it takes its robots (4). */
    @ParameterizedTest
    @ValueSource(ints = {3, 4})
    void endsABlockThatHasNotTakenItsRobots(int lookup) throws InterruptedException {
        desk.aibo.duringName(lookup, () -> desk.team.stop(List.of(desk.team.member(1)), null));
        for (String line : new String[] {"repeat 1", "aibo move 1m", "end"}) {
            desk.prompt.parseText(line);
        }
        desk.prompt.awaitAll();
        assertThat(desk.bot(1).sent()).doesNotContain("move 1000");
        assertThat(desk.said().toString()).contains("stopped").doesNotContain("done (");
    }

    /**
     * The further robot is looked up by the check of the line (2), by the check of the behaviour (3, 4), by its
     * submission (5) and when the robots are claimed for a script (6).
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6})
    void ofAFurtherRobotPreventsTheBehaviour(int lookup, @TempDir Path folder) throws Exception {
        Path both = Files.write(folder.resolve("both.majic"), List.of("2 move 1m", "1 move 1m"));
        desk.aibo.duringName(lookup, () -> desk.team.stop(List.of(desk.team.member(1)), null));
        desk.prompt.parseText("2 act \"" + both + "\" with aibo");
        desk.prompt.awaitAll();
        assertThat(desk.bot(1).sent()).doesNotContain("move 1000");
        assertThat(desk.bot(2).sent()).doesNotContain("move 1000");
        assertThat(desk.said()).contains("2 act \"" + both + "\" with aibo: not run: stopped");
    }

    @Test
    void ofAFurtherRobotDropsABehaviourThatWaits(@TempDir Path folder) throws Exception {
        Path both = Files.write(folder.resolve("both.majic"), List.of("2 move 1m", "1 move 1m"));
        String line = "2 act \"" + both + "\" with 1";
        desk.prompt.parseText("wait 1s");
        desk.prompt.parseText(line);
        desk.prompt.parseText("1 stop");
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains(line + ": not run: stopped");
        assertThat(desk.bot(2).sent()).doesNotContain("move 1000");
    }

    @Test
    void ofAFurtherRobotEndsABlockThatCommandsIt(@TempDir Path folder) throws Exception {
        Path both = Files.write(folder.resolve("both.majic"), List.of("2 move 1m", "1 move 1m"));
        for (String line : new String[] {"repeat 1", "wait 1s", "2 act \"" + both + "\" with 1", "end"}) {
            desk.prompt.parseText(line);
        }
        desk.pause(0.5);
        desk.prompt.parseText("1 stop");
        desk.prompt.awaitAll();
        assertThat(desk.said()).contains("repeat 1: stopped");
        assertThat(desk.bot(2).sent()).doesNotContain("move 1000");
    }
}

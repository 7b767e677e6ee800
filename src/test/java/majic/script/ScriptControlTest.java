package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import majic.script.run.ScriptControl;
import majic.script.run.ScriptControl.Progress;
import majic.script.run.ScriptSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Scripts that are paused, stepped and ended while they run. */
class ScriptControlTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    private final ScriptRunner runner = new ScriptRunner(fixture.session);

    private ScriptControl run(boolean paused, String... lines) {
        String text = String.join("\n", lines);
        return runner.run(new ScriptSource("lap.majic", "lap.majic", "run lap.majic", text, text), paused);
    }

    /** Lets time pass, at least once, so that all threads wait when the condition is tested. */
    private Progress await(ScriptControl control, Predicate<Progress> condition) throws InterruptedException {
        do {
            fixture.pause(0.01);
        } while (!condition.test(control.progress()));
        return control.progress();
    }

    private Progress awaitWaitingAt(ScriptControl control, int line) throws InterruptedException {
        return await(
                control, now -> now.next().orElse(0) == line && now.running().isEmpty());
    }

    private static void assertEnded(Progress progress, String outcome) {
        assertThat(progress.outcome()).startsWith(outcome);
        assertThat(progress.running()).isEmpty();
        assertThat(progress.next()).isEmpty();
    }

    @Test
    void thePlaceOfAPausedScriptHasTheValuesOfItsNames() throws InterruptedException {
        ScriptControl control = run(
                true,
                "argument speed = 60mm/s",
                "to half side",
                "  let part = $side / 2",
                "  1 move $part",
                "end",
                "let n = 2m",
                "half $n");
        assertThat(shown(awaitWaitingAt(control, 6))).isEqualTo("speed=60 mm/s");
        control.step();
        assertThat(shown(awaitWaitingAt(control, 7))).isEqualTo("n=2000 mm! speed=60 mm/s");
        control.step();
        assertThat(shown(awaitWaitingAt(control, 3))).isEqualTo("n=2000 mm side=2000 mm! speed=60 mm/s");
        control.step();
        assertThat(shown(awaitWaitingAt(control, 4))).isEqualTo("n=2000 mm part=1000 mm! side=2000 mm speed=60 mm/s");
        control.end();
    }

    @Test
    void aLineThatWaitsForItsRobotHasTheValuesThatItWasReachedWith() throws InterruptedException {
        ScriptControl control =
                run(true, "to twice way", "  1 move $way", "  1 move $way", "end", "twice 300mm", "print done");
        awaitWaitingAt(control, 5);
        control.step();
        awaitWaitingAt(control, 2);
        control.step();
        await(control, now -> now.next().orElse(0) == 3);
        control.step();
        Progress progress =
                await(control, now -> now.next().orElse(0) == 3 && now.running().contains(2));
        assertThat(shown(progress)).isEqualTo("way=300 mm");
        control.end();
    }

    @Test
    void aBlockOfOnIsSteppedBetweenTwoLines() throws InterruptedException {
        ScriptControl control =
                run(true, "on 1 x > 50", "print near", "end", "1 move 300", "print after", "print last");
        for (int line : List.of(1, 4, 5, 2, 6)) {
            awaitWaitingAt(control, line);
            control.step();
        }
        assertEnded(await(control, Progress::isOver), "done");
        assertThat(fixture.answers()).containsSubsequence("after", "near", "last");
    }

    private static String shown(Progress progress) {
        return progress.values().stream()
                .map(named -> named.name() + "=" + named.value() + (named.changed() ? "!" : ""))
                .collect(Collectors.joining(" "));
    }

    @Test
    void aScriptThatIsNotPausedRunsAsFromItsFile(@TempDir Path folder) throws Exception {
        String[] lines = {"1 move 300", "1 turn 90", "2 move 100", "repeat 2", "  2 turn 20", "end", "wait 1s"};
        await(run(false, lines), Progress::isOver);
        Path file = Files.write(folder.resolve("lap.majic"), List.of(lines));
        try (ScriptFixture other = ScriptFixture.withTwo()) {
            other.runPipe("run \"" + file + "\"");
            assertThat(fixture.bot(1).sent()).isEqualTo(other.bot(1).sent());
            assertThat(fixture.bot(2).sent()).isEqualTo(other.bot(2).sent());
        }
        assertThat(fixture.answers()).anyMatch(line -> line.startsWith("run lap.majic: done ("));
    }

    @Test
    void allRobotsOfAScriptMoveAtATime() throws InterruptedException {
        ScriptControl control = run(false, "1 move 600", "1 turn 90", "2 move 600");
        Progress both = await(control, now -> now.running().contains(3));
        assertThat(both.running()).isEqualTo(Set.of(1, 3));
        await(control, Progress::isOver);
    }

    @Test
    void theRunningMotionOfAPausedScriptEndsAndNoFurtherOneBegins() throws InterruptedException {
        ScriptControl control = run(false, "1 move 600", "1 turn 90", "2 wait", "2 move 100");
        await(control, now -> now.running().contains(1));
        fixture.pause(0.5);
        control.pause();
        awaitWaitingAt(control, 2);
        fixture.pause(5);
        assertThat(fixture.bot(1).sent()).containsExactly("move 600");
        control.resume();
        assertEnded(await(control, Progress::isOver), "done (");
        assertThat(fixture.bot(1).sent()).containsExactly("move 600", "turn 90");
    }

    @Test
    void aStepRunsOneLine() throws InterruptedException {
        ScriptControl control = run(true, "# a lap", "repeat 2", "  1,2 move 100", "end", "1 turn 90");
        for (int line : new int[] {2, 3, 2, 3, 5}) {
            awaitWaitingAt(control, line);
            control.step();
        }
        assertEnded(await(control, Progress::isOver), "done (");
        assertThat(fixture.bot(1).sent()).containsExactly("move 100", "move 100", "turn 90");
        assertThat(fixture.bot(2).sent()).containsExactly("move 100", "move 100");
    }

    @Test
    void aStepBeginsTheEarliestLineThatWaitsInAQueue() throws InterruptedException {
        ScriptControl control = run(false, "1 move 100", "1 turn 10", "1 turn 20", "1 turn 30");
        await(control, now -> now.running().contains(1));
        control.pause();
        awaitWaitingAt(control, 2);
        control.step();
        awaitWaitingAt(control, 3);
        assertThat(fixture.bot(1).sent()).containsExactly("move 100", "turn 10");
        control.end();
        await(control, Progress::isOver);
    }

    @Test
    void theLinesOfAFileThatAScriptRunsAreOneStep(@TempDir Path folder) throws Exception {
        Path inner = Files.writeString(folder.resolve("inner.majic"), "1 move 10\n1 move 20\n");
        ScriptControl control = run(true, "run \"" + inner + "\"", "1 turn 90");
        awaitWaitingAt(control, 1);
        control.step();
        awaitWaitingAt(control, 2);
        assertThat(fixture.bot(1).sent()).containsExactly("move 10", "move 20");
        control.end();
        await(control, Progress::isOver);
    }

    @Test
    void theEndOfAPausedScriptFreesItsRobots() throws InterruptedException {
        ScriptControl control = run(true, "1 move 600");
        awaitWaitingAt(control, 1);
        assertThat(fixture.prompt.parseText("1 move 10"))
                .hasValueSatisfying(why -> assertThat(why).contains("running lap.majic"));
        control.end();
        assertEnded(await(control, Progress::isOver), "stopped");
        assertThat(fixture.prompt.parseText("1 move 10")).isEmpty();
    }

    @Test
    void theEndOfAScriptStopsTheMotionThatRuns() throws InterruptedException {
        ScriptControl control = run(false, "1 move 900", "1 turn 90");
        await(control, now -> now.running().contains(1));
        fixture.pause(0.5);
        control.end();
        assertEnded(await(control, Progress::isOver), "stopped");
        assertThat(fixture.bot(1).sent()).containsExactly("move 900", "halt");
    }

    @Test
    void aStopEndsAPausedScriptAtOnce() throws InterruptedException {
        ScriptControl control = run(false, "1 move 100", "1 turn 90");
        await(control, now -> now.running().contains(1));
        control.pause();
        awaitWaitingAt(control, 2);
        fixture.team.stopAll();
        assertEnded(await(control, Progress::isOver), "stopped");
        control.resume();
        fixture.pause(1);
        assertThat(fixture.bot(1).sent()).doesNotContain("turn 90");
    }

    @Test
    void aLostConnectionEndsAPausedScript() throws InterruptedException {
        ScriptControl control = run(false, "1 move 100", "1 turn 90");
        await(control, now -> now.running().contains(1));
        control.pause();
        awaitWaitingAt(control, 2);
        fixture.bot(1).cut();
        assertEnded(await(control, Progress::isOver), "failed");
    }

    @Test
    void aSavedSessionLeavesOutWhatAPausedScriptHeldBack() throws InterruptedException {
        ScriptControl control = run(false, "1 move 150", "1 turn 90", "2 wait", "2 move 100");
        await(control, now -> now.running().contains(1));
        control.pause();
        awaitWaitingAt(control, 2);
        fixture.pause(5);
        control.end();
        await(control, Progress::isOver);
        assertThat(fixture.session.state().record().lines())
                .contains("1 move 150")
                .noneMatch(line -> line.contains("turn"));
    }

    @Test
    void aSavedSessionRepeatsAScriptThatCameToItsEnd() throws InterruptedException {
        String[] lines = {"repeat 2", "  1 move 100", "end"};
        await(run(false, lines), Progress::isOver);
        assertThat(fixture.session.state().record().lines()).containsSubsequence(lines);
    }

    @Test
    void aScriptWithMistakesDoesNotBegin() throws InterruptedException {
        ScriptControl control = run(false, "1 move 100", "1 mvoe 3", "4 stop");
        assertEnded(await(control, Progress::isOver), "failed: 2 mistakes in it, nothing was run");
        assertThat(fixture.bot(1).sent()).isEmpty();
    }

    @Test
    void aCheckReportsMistakesAndTheRobotsThatAreCommanded() {
        ScriptRunner.Checked checked = runner.check("2 move 100\nif 1 distanceFront > 3\n2 trun 3\nend");
        assertThat(checked.mistakes()).singleElement().satisfies(mistake -> {
            assertThat(mistake.line()).isEqualTo(3);
            assertThat(mistake.column()).isEqualTo(3);
        });
        assertThat(checked.robots()).containsExactly(fixture.team.member(2));
    }
}

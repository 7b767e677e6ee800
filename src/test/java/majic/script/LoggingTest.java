package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The {@code log} command fills the parameter log while robots do other things. */
class LoggingTest {
    @TempDir
    Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @Test
    void readingsAreTakenWhileTheRobotMoves() throws Exception {
        Path file = folder.resolve("log.csv");
        assertThat(fixture.runPipe(
                        "1 log x,speed every 100ms",
                        "1 move 300",
                        "1 wait",
                        "1 log off",
                        "wait 1s",
                        "save log " + file))
                .containsSubsequence(
                        "1 log x,speed every 100ms: done", "1 log off: done", "save log " + file + ": done");
        assertThat(Files.readAllLines(file))
                .hasSizeBetween(21, 25)
                .anyMatch(row -> row.endsWith(",1,speed,300.0,mm/s"));
    }

    @Test
    void aParameterIsLoggedForTheRobotsThatHaveIt() throws Exception {
        Path file = folder.resolve("log.csv");
        fixture.bot(1).equip(Parameter.number("grip", Unit.PERCENT, "of the gripper"), Value.of(40, Unit.PERCENT));

        assertThat(fixture.runPipe("all log x,grip every 100ms", "all log grip every 1s", "wait 1s"))
                .containsExactlyInAnyOrder(
                        "1 log x,grip every 100ms: done",
                        "2 log x,grip every 100ms: done; only x, it has no grip",
                        "1 log grip every 1s: done",
                        "2 log grip every 1s: nothing is logged, it has no grip");
        fixture.runPipe("all log off", "save log " + file);
        assertThat(Files.readAllLines(file))
                .anyMatch(row -> row.contains(",1,grip,"))
                .anyMatch(row -> row.contains(",2,x,"))
                .noneMatch(row -> row.contains(",2,grip,"));
        assertThat(fixture.refusal("all log gripp every 1s"))
                .hasValue("gripp: robot 1 (Aibo) has no such parameter; did you mean grip?");
    }

    @Test
    void withoutReadingsThereIsNothingToSave() throws Exception {
        Path file = folder.resolve("empty.csv");
        assertThat(fixture.runPipe("save log " + file))
                .containsExactly("save log: there are no readings yet; \"1 log x every 100ms\" takes some");
        assertThat(file).doesNotExist();
        assertThat(fixture.pipe.allSucceeded()).isFalse();
    }

    @Test
    void aRobotThatIsGoneIsNoLongerLogged() throws Exception {
        fixture.prompt.parseText("1 log x every 100ms");
        fixture.pause(0.5);
        fixture.bot(1).cut();
        fixture.pause(0.5);
        assertThat(fixture.answers()).contains("1: no longer logged: connection lost");
    }
}

package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.team.ManualControl;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A saved session is a script that does again what was done. */
class SessionRecordTest {
    @TempDir
    Path folder;

    @AutoClose
    private final ScriptFixture fixture = new ScriptFixture();

    private void type(String line) {
        assertThat(fixture.prompt.parseText(line)).isEmpty();
    }

    private void addTwo() throws InterruptedException {
        type("add sim:aibo");
        type("add sim:pioneer");
        fixture.prompt.awaitAll();
    }

    @Test
    void holdsRobotsLinesAndThePausesBetweenThem() throws InterruptedException {
        addTwo();
        type("1 move 300");
        fixture.pause(3);
        type("1 turn 90  # left");
        assertThat(fixture.session.state().record().lines())
                .containsExactly("add sim:aibo as 1", "add sim:pioneer as 2", "1 move 300", "wait 3s", "1 turn 90");
    }

    @Test
    void waitsWhereOneRobotWasStartedAfterAnotherHadFinished() throws InterruptedException {
        addTwo();
        type("1 move 300");
        fixture.pause(1.5);
        type("2 move 300");
        fixture.pause(0.5);
        type("1 move 30");
        assertThat(fixture.session.state().record().lines().subList(2, 7))
                .containsExactly("1 move 300", "1 wait", "wait 0.5s", "2 move 300", "wait 0.5s");
    }

    @Test
    void doesNotPauseAgainForWhatTakesItsTimeAnyway() throws InterruptedException {
        fixture.runPipe("add sim:aibo", "repeat 2", "  1 move 300", "  1 wait", "end", "wait 2s", "1 turn 90");
        assertThat(fixture.session.state().record().lines())
                .containsExactly(
                        "add sim:aibo as 1", "repeat 2", "  1 move 300", "  1 wait", "end", "wait 2s", "1 turn 90");
    }

    @Test
    void canBeRunAgainByTheSameTeam() throws InterruptedException {
        fixture.runPipe("add sim:aibo as 1", "1 move 30", "add sim:aibo as 1", "1 move 30");
        assertThat(fixture.pipe.allSucceeded()).isTrue();
        assertThat(fixture.answers()).contains("1: at sim:aibo, connected already");
        assertThat(fixture.session.state().record().lines()).containsOnlyOnce("add sim:aibo as 1");
    }

    @Test
    void leavesOutWhatWasRefusedAndWhatChangedNothing() throws InterruptedException {
        addTwo();
        type("bots");
        type("1 help");
        fixture.prompt.parseText("1 mvoe 3");
        fixture.prompt.parseText("1 set x 3");
        assertThat(fixture.session.state().record().lines()).hasSize(2);
    }

    @Test
    void repeatsAStopWithoutEndingTheReplay() throws InterruptedException {
        addTwo();
        type("1 move 3m");
        fixture.pause(1);
        type("stop");
        type("release");
        assertThat(fixture.session.state().record().lines().subList(2, 5))
                .containsExactly("1 move 3m", "wait 1s", "1,2 stop");
    }

    @Test
    void aTypedReadingStaysOneAtOnce() throws InterruptedException {
        addTwo();
        type("1 move 300");
        type("1 get x");
        assertThat(fixture.session.state().record().lines()).endsWith("1 get now x");
    }

    @Test
    void savedAndRunAgainItDoesTheSame() throws Exception {
        addTwo();
        for (String line :
                List.of("repeat 2", "  1 move 300", "end", "wait", "2 turn 90", "2 wait", "1 set headPan 9")) {
            type(line);
        }
        fixture.prompt.awaitAll();
        Path file = folder.resolve("my session.majic");
        assertThat(fixture.runPipe("save session \"" + file + "\"")).endsWith("save session \"" + file + "\": done");
        try (ScriptFixture again = new ScriptFixture()) {
            again.runPipe("run \"" + file + "\"");
            assertThat(again.pipe.allSucceeded()).as(again.answers().toString()).isTrue();
            assertThat(again.bot(1).sent()).isEqualTo(fixture.bot(1).sent());
            assertThat(again.bot(2).sent()).isEqualTo(fixture.bot(2).sent());
        }
        assertThat(Files.readAllLines(file)).first().asString().startsWith("#");
    }

    @Test
    void aMoveThatTheStopButtonStoppedIsStoppedAgain() throws Exception {
        addTwo();
        type("2 move 300");
        fixture.pause(2);
        type("1 move 999");
        fixture.pause(0.96);
        fixture.team.stopAll();
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines())
                .endsWith("2 move 300", "2 wait", "wait 1s", "1 move 999", "wait 0.96s", "1,2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1 drive 300 0 for 3s", "1 drive 300 0", "1 act FILE", "run FILE", "1 move 3m; 1 wait"})
    void whatTheStopButtonStoppedIsStoppedAgain(String line) throws Exception {
        addTwo();
        Path script =
                Files.write(folder.resolve("far.majic"), List.of(line.contains("act") ? "move 999" : "1 move 999"));
        for (String part : line.replace("FILE", '"' + script.toString() + '"').split("; ")) {
            type(part);
        }
        fixture.pause(0.96);
        fixture.team.stopAll();
        fixture.prompt.awaitAll();
        fixture.pause(1);
        assertThat(fixture.session.state().record().lines()).endsWith("1,2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void theStopOfOneRobotByItsButtonIsKept() throws Exception {
        addTwo();
        type("1,2 move 999");
        fixture.pause(1.21);
        fixture.team.stop(List.of(fixture.team.member(2)), null);
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines()).endsWith("1,2 move 999", "wait 1.21s", "2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aWrongLineThatWasTakenAsStopIsKept() throws Exception {
        addTwo();
        type("1 move 999");
        fixture.pause(1);
        fixture.prompt.parseText("1 stopp stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines()).endsWith("1 move 999", "wait 1s", "1,2 stop");
    }

    @Test
    void waitsForNoRobotDuringAMotionThatWasStopped() throws Exception {
        addTwo();
        type("1 move 300");
        type("2 move 5m");
        fixture.pause(2);
        type("1 turn 90");
        fixture.pause(3.03);
        fixture.team.stop(List.of(fixture.team.member(2)), null);
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines().subList(2, 7))
                .containsExactly("1 move 300", "2 move 5m", "wait 2s", "1 turn 90", "wait 3.03s");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void ofABlockThatWasStoppedWhatItDidIsKept() throws Exception {
        addTwo();
        for (String line : List.of("repeat", "  all move 100", "  1 wait", "  1 turn 90", "  1 wait", "end")) {
            type(line);
        }
        fixture.pause(3.03);
        fixture.team.stopAll();
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines())
                .doesNotContain("repeat")
                .containsSubsequence("1,2 move 100", "1 turn 90", "1,2 move 100", "1 turn 90", "1,2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aBlockBesideWhichARobotWasStoppedIsReplayedInTime() throws Exception {
        addTwo();
        type("2 move 5m");
        for (String line : List.of("repeat 3", "  1 move 600", "end")) {
            type(line);
        }
        fixture.pause(1.03);
        fixture.team.stop(List.of(fixture.team.member(2)), null);
        fixture.prompt.awaitAll();
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aScriptThatEndsByTheStopOfOneRobotStopsTheOthersAgain() throws Exception {
        addTwo();
        for (String line : List.of("repeat 1", "  1 move 1m", "  2 move 2m", "  wait", "end")) {
            type(line);
        }
        fixture.pause(1.03);
        fixture.team.stop(List.of(fixture.team.member(1)), null);
        fixture.prompt.awaitAll();
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aRobotThatWasRemovedAsItMovedIsStoppedInTime() throws Exception {
        addTwo();
        type("2 move 3m");
        fixture.pause(1);
        type("remove 2");
        fixture.prompt.awaitAll();
        assertThat(fixture.session.state().record().lines()).endsWith("2 move 3m", "wait 1s", "2 stop", "remove 2");
    }

    @Test
    void manualControlIsReplayedAsDrives() throws Exception {
        addTwo();
        ManualControl hand = new ManualControl(fixture.team.member(1));
        for (int tick = 0; tick < 10; tick++) {
            hand.drive(200, tick < 4 ? 0 : 15.5);
            fixture.pause(0.15);
        }
        hand.close();
        fixture.pause(1);
        type("1 turn 90");
        assertThat(fixture.session.state().record().lines())
                .endsWith("1 drive 200 0 for 0.6s", "wait 0.6s", "1 drive 200 15.5 for 0.9s", "wait 1.9s", "1 turn 90");
    }

    @Test
    void theSecondStopIsKeptIfItEndsManualControl() throws Exception {
        addTwo();
        fixture.team.stopAll();
        fixture.team.release();
        fixture.pause(1);
        ManualControl hand = new ManualControl(fixture.team.member(1));
        hand.drive(200, 0);
        fixture.pause(0.3);
        fixture.team.stopAll();
        fixture.pause(1);
        assertThat(hand.isOff()).isTrue();
        assertThat(fixture.session.state().record().lines())
                .endsWith("1,2 stop", "wait 1s", "1 drive 200 0 for 0.3s", "wait 0.3s", "1,2 stop");
    }

    @Test
    void aManualDriveThatExpiredLastsUntilItExpired() throws Exception {
        addTwo();
        ManualControl hand = new ManualControl(fixture.team.member(1));
        hand.drive(200, 0);
        fixture.pause(5);
        hand.close();
        fixture.pause(1);
        assertThat(fixture.session.state().record().lines()).endsWith("1 drive 200 0 for 0.6s");
    }

    @Test
    void aTimeInMillisecondsThatASliderSetIsKeptWithItsUnit() throws Exception {
        addTwo();
        fixture.bot(1).equip(Parameter.number("rest", Unit.MS, "after each step"), Value.of(100, Unit.MS));
        ManualControl hand = new ManualControl(fixture.team.member(1));
        hand.set("rest", 250);
        hand.finish();
        fixture.pause(1);
        assertThat(fixture.session.state().record().lines()).endsWith("1 set rest 250ms");
    }

    @Test
    void whatASliderSetIsKept() throws Exception {
        addTwo();
        ManualControl hand = new ManualControl(fixture.team.member(1));
        hand.set("headPan", 12.5);
        hand.finish();
        fixture.pause(1);
        assertThat(fixture.session.state().record().lines()).endsWith("1 set headPan 12.5");
    }

    @Test
    void namesTheRobotsByNumber() throws Exception {
        addTwo();
        type("all move 100");
        type("aibo set light on");
        type("1-2 set title \"a b\"");
        type("1 move 100 until (bumped == yes or headPan > 3) and not distanceFront < 10");
        assertThat(fixture.session.state().record().lines())
                .endsWith(
                        "1,2 move 100",
                        "1 set light on",
                        "1,2 set title \"a b\"",
                        "1 move 100 until (bumped == yes or headPan > 3) and not distanceFront < 10");
    }

    @Test
    void filesAreNamedSoThatTheyAreFoundFromEverywhere() throws Exception {
        addTwo();
        Path working = Path.of("").toAbsolutePath();
        Path script = Files.write(folder.resolve("there.majic"), List.of("1 move 100", "wait"));
        Path relative = working.relativize(script);
        type("run \"" + relative + "\"");
        fixture.prompt.awaitAll();
        type("2 act \"" + relative + "\"");
        fixture.prompt.awaitAll();
        Path absolute = working.resolve(relative);
        assertThat(fixture.session.state().record().lines()).contains("run " + absolute, "2 act " + absolute);
    }

    /** Both robots drive ahead only, or turn; a replay must not get further, and at most a little less far. */
    private void assertThatReplayEndsWhereThisDid() throws Exception {
        Path file = folder.resolve("saved.majic");
        fixture.session.state().record().save(file);
        try (ScriptFixture again = new ScriptFixture()) {
            again.runPipe("run \"" + file + "\"");
            assertThat(again.pipe.allSucceeded()).as(again.answers().toString()).isTrue();
            for (int robot = 1; robot <= 2; robot++) {
                Pose first = fixture.bot(robot).state().pose();
                Pose second = again.bot(robot).state().pose();
                assertThat(second.xMm()).isCloseTo(first.xMm(), within(0.1));
                assertThat(second.yMm()).isCloseTo(first.yMm(), within(0.1));
            }
        }
    }

    @Test
    void aFolderIsNotOverwritten() throws InterruptedException {
        assertThat(fixture.runPipe("save session " + folder))
                .containsExactly(folder + ": cannot be written (is a directory)");
    }

    @Test
    void aMissingFolderIsNamed() throws InterruptedException {
        Path file = folder.resolve("none/session.majic");
        assertThat(fixture.runPipe("save session " + file))
                .containsExactly(file + ": cannot be written (there is no such folder or file)");
    }
}

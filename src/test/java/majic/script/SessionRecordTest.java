package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.Pose;
import majic.team.ManualControl;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A saved session is a script that does again what was done. */
@Timeout(30)
class SessionRecordTest {
    @TempDir
    Path folder;

    @AutoClose
    private final Desk desk = new Desk();

    private void type(String line) {
        assertThat(desk.prompt.parseText(line)).isEmpty();
    }

    private void addTwo() throws InterruptedException {
        type("add sim:aibo");
        type("add sim:pioneer");
        desk.prompt.awaitAll();
    }

    @Test
    void holdsRobotsLinesAndThePausesBetweenThem() throws InterruptedException {
        addTwo();
        type("1 move 300");
        desk.pause(3);
        type("1 turn 90  # left");
        assertThat(desk.session.state().record().lines())
                .containsExactly("add sim:aibo as 1", "add sim:pioneer as 2", "1 move 300", "wait 3s", "1 turn 90");
    }

    @Test
    void waitsWhereOneRobotWasStartedAfterAnotherHadFinished() throws InterruptedException {
        addTwo();
        type("1 move 300");
        desk.pause(1.5);
        type("2 move 300");
        desk.pause(0.5);
        type("1 move 30");
        assertThat(desk.session.state().record().lines().subList(2, 7))
                .containsExactly("1 move 300", "1 wait", "wait 0.5s", "2 move 300", "wait 0.5s");
    }

    @Test
    void doesNotPauseAgainForWhatTakesItsTimeAnyway() throws InterruptedException {
        desk.runPipe("add sim:aibo", "repeat 2", "  1 move 300", "  1 wait", "end", "wait 2s", "1 turn 90");
        assertThat(desk.session.state().record().lines())
                .containsExactly(
                        "add sim:aibo as 1", "repeat 2", "  1 move 300", "  1 wait", "end", "wait 2s", "1 turn 90");
    }

    @Test
    void canBeDoneAgainByTheTeamThatDidIt() throws InterruptedException {
        desk.runPipe("add sim:aibo as 1", "1 move 30", "add sim:aibo as 1", "1 move 30");
        assertThat(desk.pipe.allSucceeded()).isTrue();
        assertThat(desk.said()).contains("1: at sim:aibo, connected already");
        assertThat(desk.session.state().record().lines()).containsOnlyOnce("add sim:aibo as 1");
    }

    @Test
    void leavesOutWhatWasRefusedAndWhatChangedNothing() throws InterruptedException {
        addTwo();
        type("bots");
        type("1 help");
        desk.prompt.parseText("1 mvoe 3");
        desk.prompt.parseText("1 set x 3");
        assertThat(desk.session.state().record().lines()).hasSize(2);
    }

    @Test
    void repeatsAStopWithoutEndingTheReplay() throws InterruptedException {
        addTwo();
        type("1 move 3m");
        desk.pause(1);
        type("stop");
        type("release");
        assertThat(desk.session.state().record().lines().subList(2, 5))
                .containsExactly("1 move 3m", "wait 1s", "1,2 stop");
    }

    @Test
    void aTypedReadingStaysOneAtOnce() throws InterruptedException {
        addTwo();
        type("1 move 300");
        type("1 get x");
        assertThat(desk.session.state().record().lines()).endsWith("1 get now x");
    }

    @Test
    void savedAndRunAgainItDoesTheSame() throws Exception {
        addTwo();
        for (String line :
                List.of("repeat 2", "  1 move 300", "end", "wait", "2 turn 90", "2 wait", "1 set headPan 9")) {
            type(line);
        }
        desk.prompt.awaitAll();
        Path file = folder.resolve("my session.majic");
        assertThat(desk.runPipe("save session \"" + file + "\"")).endsWith("save session \"" + file + "\": done");
        try (Desk again = new Desk()) {
            again.runPipe("run \"" + file + "\"");
            assertThat(again.pipe.allSucceeded()).as(again.said().toString()).isTrue();
            assertThat(again.bot(1).sent()).isEqualTo(desk.bot(1).sent());
            assertThat(again.bot(2).sent()).isEqualTo(desk.bot(2).sent());
        }
        assertThat(Files.readAllLines(file)).first().asString().startsWith("#");
    }

    @Test
    void aMoveThatTheStopButtonCutIsCutAgain() throws Exception {
        addTwo();
        type("2 move 300");
        desk.pause(2);
        type("1 move 999");
        desk.pause(0.96);
        desk.team.stopAll();
        desk.prompt.awaitAll();
        assertThat(desk.session.state().record().lines())
                .endsWith("2 move 300", "2 wait", "wait 1s", "1 move 999", "wait 0.96s", "1,2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1 drive 300 0 for 3s", "1 drive 300 0", "1 act FILE", "run FILE", "1 move 3m; 1 wait"})
    void whateverTheStopButtonCutIsCutAgain(String line) throws Exception {
        addTwo();
        Path script =
                Files.write(folder.resolve("far.majic"), List.of(line.contains("act") ? "move 999" : "1 move 999"));
        for (String part : line.replace("FILE", '"' + script.toString() + '"').split("; ")) {
            type(part);
        }
        desk.pause(0.96);
        desk.team.stopAll();
        desk.prompt.awaitAll();
        desk.pause(1);
        assertThat(desk.session.state().record().lines()).endsWith("1,2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void theStopOfOneRobotByItsButtonIsKept() throws Exception {
        addTwo();
        type("1,2 move 999");
        desk.pause(1.21);
        desk.team.stop(List.of(desk.team.member(2)), null);
        desk.prompt.awaitAll();
        assertThat(desk.session.state().record().lines()).endsWith("1,2 move 999", "wait 1.21s", "2 stop");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aWrongLineThatWasTakenAsStopIsKept() throws Exception {
        addTwo();
        type("1 move 999");
        desk.pause(1);
        desk.prompt.parseText("1 stopp stop");
        desk.prompt.awaitAll();
        assertThat(desk.session.state().record().lines()).endsWith("1 move 999", "wait 1s", "1,2 stop");
    }

    @Test
    void waitsForNobodyWhileAMotionIsUnderWayThatWasStopped() throws Exception {
        addTwo();
        type("1 move 300");
        type("2 move 5m");
        desk.pause(2);
        type("1 turn 90");
        desk.pause(3.03);
        desk.team.stop(List.of(desk.team.member(2)), null);
        desk.prompt.awaitAll();
        assertThat(desk.session.state().record().lines().subList(2, 7))
                .containsExactly("1 move 300", "2 move 5m", "wait 2s", "1 turn 90", "wait 3.03s");
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void ofABlockThatWasStoppedWhatItDidIsKept() throws Exception {
        addTwo();
        for (String line : List.of("repeat", "  all move 100", "  1 wait", "  1 turn 90", "  1 wait", "end")) {
            type(line);
        }
        desk.pause(3.03);
        desk.team.stopAll();
        desk.prompt.awaitAll();
        assertThat(desk.session.state().record().lines())
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
        desk.pause(1.03);
        desk.team.stop(List.of(desk.team.member(2)), null);
        desk.prompt.awaitAll();
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aScriptThatEndsByTheStopOfOneRobotStopsTheOthersAgain() throws Exception {
        addTwo();
        for (String line : List.of("repeat 1", "  1 move 1m", "  2 move 2m", "  wait", "end")) {
            type(line);
        }
        desk.pause(1.03);
        desk.team.stop(List.of(desk.team.member(1)), null);
        desk.prompt.awaitAll();
        assertThatReplayEndsWhereThisDid();
    }

    @Test
    void aRobotThatWasRemovedAsItMovedIsStoppedInTime() throws Exception {
        addTwo();
        type("2 move 3m");
        desk.pause(1);
        type("remove 2");
        desk.prompt.awaitAll();
        assertThat(desk.session.state().record().lines()).endsWith("2 move 3m", "wait 1s", "2 stop", "remove 2");
    }

    @Test
    void drivingByHandIsReplayedAsDrives() throws Exception {
        addTwo();
        ManualControl hand = new ManualControl(desk.team.member(1));
        for (int tick = 0; tick < 10; tick++) {
            hand.drive(200, tick < 4 ? 0 : 15.5);
            desk.pause(0.15);
        }
        hand.close();
        desk.pause(1);
        type("1 turn 90");
        assertThat(desk.session.state().record().lines())
                .endsWith("1 drive 200 0 for 0.6s", "wait 0.6s", "1 drive 200 15.5 for 0.9s", "wait 1.9s", "1 turn 90");
    }

    @Test
    void theSecondStopIsKeptIfItEndsDrivingByHand() throws Exception {
        addTwo();
        desk.team.stopAll();
        desk.team.release();
        desk.pause(1);
        ManualControl hand = new ManualControl(desk.team.member(1));
        hand.drive(200, 0);
        desk.pause(0.3);
        desk.team.stopAll();
        desk.pause(1);
        assertThat(hand.isOff()).isTrue();
        assertThat(desk.session.state().record().lines())
                .endsWith("1,2 stop", "wait 1s", "1 drive 200 0 for 0.3s", "wait 0.3s", "1,2 stop");
    }

    @Test
    void aDriveByHandThatExpiredCountsUntilThen() throws Exception {
        addTwo();
        ManualControl hand = new ManualControl(desk.team.member(1));
        hand.drive(200, 0);
        desk.pause(5);
        hand.close();
        desk.pause(1);
        assertThat(desk.session.state().record().lines()).endsWith("1 drive 200 0 for 0.6s");
    }

    @Test
    void whatASliderSetIsKept() throws Exception {
        addTwo();
        ManualControl hand = new ManualControl(desk.team.member(1));
        hand.set("headPan", 12.5);
        hand.finish();
        desk.pause(1);
        assertThat(desk.session.state().record().lines()).endsWith("1 set headPan 12.5");
    }

    @Test
    void namesTheRobotsThatWereMeant() throws Exception {
        addTwo();
        type("all move 100");
        type("aibo set light on");
        type("1-2 set title \"a b\"");
        type("1 move 100 until (bumped == yes or headPan > 3) and not distanceFront < 10");
        assertThat(desk.session.state().record().lines())
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
        desk.prompt.awaitAll();
        type("2 act \"" + relative + "\"");
        desk.prompt.awaitAll();
        Path absolute = working.resolve(relative);
        assertThat(desk.session.state().record().lines()).contains("run " + absolute, "2 act " + absolute);
    }

    /** Both robots drive ahead only, or turn; a replay must not get further, and at most a little less far. */
    private void assertThatReplayEndsWhereThisDid() throws Exception {
        Path file = folder.resolve("saved.majic");
        desk.session.state().record().save(file);
        try (Desk again = new Desk()) {
            again.runPipe("run \"" + file + "\"");
            assertThat(again.pipe.allSucceeded()).as(again.said().toString()).isTrue();
            for (int robot = 1; robot <= 2; robot++) {
                Pose first = desk.bot(robot).state().pose();
                Pose second = again.bot(robot).state().pose();
                assertThat(second.xMm()).isCloseTo(first.xMm(), within(0.1));
                assertThat(second.yMm()).isCloseTo(first.yMm(), within(0.1));
            }
        }
    }

    @Test
    void whereAFolderLiesNothingIsSaved() throws InterruptedException {
        assertThat(desk.runPipe("save session " + folder))
                .containsExactly(folder + ": cannot be written (is a directory)");
    }

    @Test
    void aFolderThatIsNotThereIsNamed() throws InterruptedException {
        Path file = folder.resolve("none/session.majic");
        assertThat(desk.runPipe("save session " + file))
                .containsExactly(file + ": cannot be written (there is no such folder or file)");
    }
}

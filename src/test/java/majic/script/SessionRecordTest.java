package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A saved session is a script that does again what was done. */
@Timeout(30)
class SessionRecordTest {
    @TempDir
    Path folder;

    private final Desk desk = new Desk();

    @AfterEach
    void close() {
        desk.close();
    }

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
        assertThat(desk.session.record().lines())
                .containsExactly(
                        "add sim:aibo as 1", "add sim:pioneer as 2", "1 move 300", "wait 3.0s", "1 turn 90  # left");
    }

    @Test
    void waitsWhereOneRobotWasStartedAfterAnotherHadFinished() throws InterruptedException {
        addTwo();
        type("1 move 300");
        desk.pause(1.5);
        type("2 move 300");
        desk.pause(0.5);
        type("1 move 30");
        assertThat(desk.session.record().lines().subList(2, 7))
                .containsExactly("1 move 300", "1 wait", "wait 0.5s", "2 move 300", "wait 0.5s");
    }

    @Test
    void doesNotPauseAgainForWhatTakesItsTimeAnyway() throws InterruptedException {
        desk.runPipe("add sim:aibo", "repeat 2", "  1 move 300", "  1 wait", "end", "wait 2s", "1 turn 90");
        assertThat(desk.session.record().lines())
                .containsExactly(
                        "add sim:aibo as 1", "repeat 2", "  1 move 300", "  1 wait", "end", "wait 2s", "1 turn 90");
    }

    @Test
    void canBeDoneAgainByTheTeamThatDidIt() throws InterruptedException {
        desk.runPipe("add sim:aibo as 1", "1 move 30", "add sim:aibo as 1", "1 move 30");
        assertThat(desk.pipe.allSucceeded()).isTrue();
        assertThat(desk.said()).contains("1: at sim:aibo, connected already");
        assertThat(desk.session.record().lines()).containsOnlyOnce("add sim:aibo as 1");
    }

    @Test
    void leavesOutWhatWasRefusedAndWhatChangedNothing() throws InterruptedException {
        addTwo();
        type("bots");
        type("1 help");
        desk.prompt.parseText("1 mvoe 3");
        desk.prompt.parseText("1 set x 3");
        assertThat(desk.session.record().lines()).hasSize(2);
    }

    @Test
    void repeatsAStopWithoutEndingTheReplay() throws InterruptedException {
        addTwo();
        type("1 move 3m");
        desk.pause(1);
        type("stop");
        type("release");
        assertThat(desk.session.record().lines().subList(2, 5)).containsExactly("1 move 3m", "wait 1.0s", "1,2 stop");
    }

    @Test
    void aTypedReadingStaysOneAtOnce() throws InterruptedException {
        addTwo();
        type("1 move 300");
        type("1 get x");
        assertThat(desk.session.record().lines()).endsWith("1 get now x");
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
    void aFolderThatIsNotThereIsNamed() throws InterruptedException {
        Path file = folder.resolve("none/session.majic");
        assertThat(desk.runPipe("save session " + file))
                .containsExactly(file + ": cannot be written (there is no such folder or file)");
    }
}

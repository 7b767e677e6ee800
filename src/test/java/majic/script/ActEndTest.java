package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.act.ActDetails;
import majic.act.make.ActMaker;
import majic.bot.FakeBot;
import majic.team.Owner;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** When a behaviour in MAJIC Script ends, all it has ordered ends with it, on each of its robots. */
class ActEndTest {
    /** Drives robot 1 by repeated commands for half a minute. */
    private static final String LONG_DRIVE = "1 drive 100 0 for 30s";

    @TempDir
    private Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    private FakeBot driver;

    @BeforeEach
    void name() {
        driver = fixture.bot(1);
    }

    private String file(String... lines) throws IOException {
        Path path = Files.write(folder.resolve("both.majic"), List.of(lines));
        return '"' + path.toString() + '"';
    }

    private void assertThatItIsStationary() throws InterruptedException {
        int sent = driver.sent().size();
        fixture.pause(5);
        assertThat(driver.sent()).hasSize(sent).endsWith("halt");
    }

    @Test
    void theFailureOfOneRobotStopsTheOthers() throws Exception {
        fixture.bot(2).stallAfter(200);
        fixture.runPipe("1 act " + file(LONG_DRIVE, "2 move 400", "wait") + " with 2");
        assertThatItIsStationary();
    }

    @Test
    void theStopOfOneRobotStopsTheOthers() throws Exception {
        fixture.prompt.parseText("1 act " + file(LONG_DRIVE, "2 move 5000", "wait") + " with 2");
        fixture.pause(1);
        fixture.prompt.parseText("2 stop");
        fixture.prompt.awaitAll();
        assertThatItIsStationary();
    }

    @Test
    void actOffStopsItsRobots() throws Exception {
        fixture.prompt.parseText("1 act " + file(LONG_DRIVE, "2 move 5000", "wait") + " with 2");
        fixture.pause(1);
        fixture.prompt.parseText("2 act off");
        fixture.prompt.awaitAll();
        assertThatItIsStationary();
    }

    @Test
    void actOffBeforeItsTurnPreventsIt() throws Exception {
        String drive = file("me move 5000");
        assertThat(fixture.runPipe("1 move 300", "1 act " + drive, "1 act off", "1 turn 90"))
                .contains("1 act off: no act runs on it", "1 act " + drive + ": not run: stopped");
        assertThat(driver.sent()).containsSubsequence("move 300", "turn 90").doesNotContain("move 5000");
    }

    @Test
    void doneMeansForTheNextLineThatTheRobotIsFree() throws Exception {
        String ahead = file("repeat", "me move 100", "end");
        assertThat(fixture.runPipe("1 act " + ahead, "wait 3s", "1 act off", "1 turn 20"))
                .contains("1 act off: done")
                .noneMatch(line -> line.contains("is running"));
        assertThat(driver.sent()).containsSubsequence("move 100", "halt", "turn 20");
    }

    @Test
    void atAPromptItIsAnsweredWhenTheRobotIsFree() throws Exception {
        List<Optional<Owner>> owners = new CopyOnWriteArrayList<>();
        fixture.session.addListener(line -> {
            if (line.text().equals("1 act off: done")) {
                owners.add(Optional.ofNullable(fixture.team.member(1).owner()));
            }
        });
        driver.standAfter(1);
        fixture.prompt.parseText("1 act " + file("repeat", "me move 100", "end"));
        fixture.pause(3);
        fixture.prompt.parseText("1 act off");
        fixture.prompt.awaitAll();
        assertThat(owners).containsExactly(Optional.empty());
    }

    /**
     * Two sources stop a robot whose act ends only after it was reported to be slow: the robot is free at each answer.
     */
    @Test
    void stopIsDoneWhenAnActThatIsSlowToEndHasReleasedTheRobot() throws Exception {
        List<Optional<Owner>> ownersAtDone = new CopyOnWriteArrayList<>();
        List<Optional<String>> refusalsAtDone = new CopyOnWriteArrayList<>();
        fixture.session.addListener(line -> {
            if (line.text().endsWith("Deaf: is still ending; its robots are stopped and no longer obey it")) {
                System.setProperty("deaf.hears", "now");
            } else if (line.text().equals("1 stop: done")) {
                ownersAtDone.add(Optional.ofNullable(fixture.team.member(1).owner()));
                refusalsAtDone.add(fixture.prompt.parseText("1 move 20"));
            }
        });
        startDeaf();
        fixture.prompt.parseText("1 stop");
        MajicParser socket = MajicParser.socket(fixture.session);
        socket.parseText("1 stop");
        fixture.prompt.awaitAll();
        socket.awaitAll();
        fixture.session.flush();
        assertThat(ownersAtDone).containsExactly(Optional.empty(), Optional.empty());
        assertThat(refusalsAtDone).containsExactly(Optional.empty(), Optional.empty());
    }

    /** Starts an act that ignores its end, waits until it runs and returns the name of its file. */
    private String startDeaf() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        fixture.session.addListener(line -> {
            if (line.text().endsWith("Deaf: deaf")) {
                begun.countDown();
            }
        });
        String name = deaf();
        fixture.prompt.parseText("1 act " + name);
        begun.await();
        return name;
    }

    @Test
    void anActThatDoesNotEndIsReportedAsLeftBehind() throws Exception {
        String name = startDeaf();
        List<String> said = fixture.runPipe("1 act off");
        assertThat(fixture.prompt.parseText("1 turn 20")).isEmpty();
        assertThat(said)
                .containsSubsequence(
                        "1: Deaf: is still ending; its robots are stopped and no longer obey it",
                        "1: Deaf: does not end; it is left behind without a robot",
                        "1 act off: done");
        assertThat(fixture.answers()).noneMatch(line -> line.startsWith("1 act " + name + ": done"));
        System.setProperty("deaf.hears", "now");
    }

    @Test
    void actOffIsAnsweredOnceThoughAStopEndsTheWaitForTheAct() throws Exception {
        driver.standAfter(1);
        fixture.prompt.parseText("1 act " + file("repeat", "me move 100", "end"));
        fixture.pause(3);
        MajicParser pipe = MajicParser.pipe(fixture.session);
        pipe.parseText("1 act off");
        fixture.pause(0.2);
        fixture.prompt.parseText("stop");
        pipe.awaitAll();
        assertThat(fixture.answers())
                .filteredOn(line -> line.startsWith("1 act off:"))
                .containsExactly("1 act off: done");
    }

    /** The file of an act that pays no attention to anything until a property is set, and waits on no clock. */
    private String deaf() throws IOException {
        System.clearProperty("deaf.hears");
        Path source = Files.writeString(
                folder.resolve("Deaf.java"),
                "public class Deaf extends majic.act.MajicAct {\n"
                        + "  protected void behave() {\n"
                        + "    say(\"deaf\");\n"
                        + "    while (System.getProperty(\"deaf.hears\") == null) { Thread.onSpinWait(); }\n"
                        + "  }\n"
                        + "}\n");
        Path act =
                Files.write(folder.resolve("Deaf.act"), ActMaker.from(source).make("Deaf", ActDetails.named("Deaf")));
        fixture.session.offers().agree(fixture.session.offers().find(act.toString()));
        return '"' + act.toString() + '"';
    }

    @Test
    void itsOwnStopEndsNoCommandOfAnotherSource() throws Exception {
        String stops = file("me drive 100 0 for 30s", "wait 1s", "me stop", "me move 50");
        assertThat(fixture.runPipe("repeat 2", "1 act " + stops, "1 turn 90", "end"))
                .noneMatch(line -> line.contains("not run") || line.contains("failed"))
                .contains("1 drive 100 0 for 30s: stopped");
        assertThat(driver.sent()).containsSubsequence("move 50", "turn 90", "move 50", "turn 90");
    }
}

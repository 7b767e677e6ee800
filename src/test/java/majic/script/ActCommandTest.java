package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import majic.act.ActDetails;
import majic.act.file.ActFile;
import majic.act.make.ActMaker;
import majic.team.Member;
import majic.team.Owner;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests a script as a behaviour: loaded onto a robot, run as an act, ended by a stop. */
class ActCommandTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    private String file(String name, String... lines) throws IOException {
        Path path = Files.write(folder.resolve(name), List.of(lines));
        return '"' + path.toString() + '"';
    }

    @Test
    void theRobotItRunsOnIsMe() throws Exception {
        String square = file("square.majic", "repeat 2", "  me move 300", "  me turn 90", "end");
        assertThat(fixture.runPipe("2 act " + square))
                .anyMatch(line -> line.startsWith("2 act ") && line.contains("done"));
        assertThat(fixture.bot(2).sent()).startsWith("move 300", "turn 90", "move 300", "turn 90");
        assertThat(fixture.bot(1).sent()).doesNotContain("move 300");
    }

    @Test
    void numbersInItAreRolesThatRobotsAreAssignedTo() throws Exception {
        String both = file("both.majic", "7 move 100", "8 move 200", "wait");
        assertThat(fixture.refusal("1 act " + both))
                .get()
                .asString()
                .contains("needs 1 more (robot8): 1 act " + both.replace("\"", "") + " with N");
        fixture.runPipe("2 act " + both + " with 1");
        assertThat(fixture.bot(2).sent()).startsWith("move 100");
        assertThat(fixture.bot(1).sent()).startsWith("move 200");
    }

    @Test
    void tooManyRobotsAreRefusedAsTooMany() throws Exception {
        fixture.add(fixture.pioneer);
        String both = file("both.majic", "7 move 100", "8 move 200");
        assertThat(fixture.refusal("1 act " + both + " with 2,3"))
                .get()
                .asString()
                .contains("takes 1 more (robot8), not 2: 1 act " + both.replace("\"", "") + " with N");
    }

    @Test
    void aRefusalBeginsWithTheFileAsItWasTyped() throws Exception {
        Path folders = Files.createDirectories(folder.resolve("some/folder"));
        Path both = Files.write(folders.resolve("both.majic"), List.of("7 move 100", "8 move 200"));
        Path typed = Path.of("").toAbsolutePath().relativize(both);
        assertThat(fixture.refusal("1 act " + typed)).get().asString().startsWith(typed + ": needs 1 more");
    }

    @ParameterizedTest
    @CsvSource({
        "me set sonar 5, robot 1 has no parameter sonar",
        "me move 5 until distanceLeft < near, robot 1 has no parameter distanceLeft",
        "me get lighd, robot 1 has no parameter lighd; did you mean light?",
        "me jump, robot 1 has no command jump",
        "all jump, robot 1 has no command jump",
        "me set voltage 5, lacking.majic:1:8: voltage: can be read but not set",
        "me set headPan 400, lacking.majic:1:16: ",
        "me wag, lacking.majic:1:4: wag",
        "me drive 5000 0, lacking.majic:1:10: ",
    })
    void whatItCommandsIsCheckedAgainstTheRobotBeforeItIsLoaded(String line, String why) throws Exception {
        String lacking = file("lacking.majic", line, "me move 10");
        assertThat(fixture.refusal("1 act " + lacking)).get().asString().contains(why);
        assertThat(fixture.bot(1).sent()).isEmpty();
    }

    @Test
    void aSavedScriptIsCheckedAgainstTheRobotToo() throws Exception {
        byte[] saved = ActMaker.save(new ScriptAct("there", "me get sonar"), ActDetails.named("There"));
        Path file = Files.write(folder.resolve("there.act"), saved);
        assertThat(ActFile.read(file).roles()).hasToString("[me (sonar)]");
        assertThat(fixture.refusal("1 act \"" + file + '"'))
                .get()
                .asString()
                .contains("robot 1 has no parameter sonar");
        assertThat(fixture.session.offers().find(file.toString()).roles().get(0).unfit(fixture.bot(1)))
                .contains("has no parameter sonar");
    }

    @Test
    void aShippedScriptIsCheckedAgainstTheRobotToo() throws Exception {
        assertThat(fixture.refusal("1 act PioneerWander"))
                .contains("PioneerWander: robot 1 has no parameter distanceLeft");
    }

    @Test
    void whatTheRobotCannotRunIsNotOffered() throws Exception {
        assertThat(fixture.prompt.complete("1 act ", 6).words())
                .contains("AiboSquare", "off")
                .doesNotContain("PioneerWander", "WallFollow");
        assertThat(fixture.runPipe("acts"))
                .anyMatch(
                        line -> line.startsWith(
                                "acts: PioneerWander (me (distanceFront,distanceLeft,distanceRight,near,cruise)): A robot drives"));
    }

    @Test
    void aMistakeThatOnlyTheRobotShowsIsReportedOnce() throws Exception {
        String lacking = file("lacking.majic", "me set voltage 5");
        List<String> said = fixture.runPipe("add sim:aibo as 5", "5 act " + lacking);
        assertThat(said.stream().filter(line -> line.contains("can be read but not set")))
                .hasSize(1);
    }

    @Test
    void aSavedSessionBecomesOneWithItsTypesOfRobots() throws Exception {
        String saved = file(
                "saved.majic", "add sim:aibo as 1", "1 name Rex", "add sim:pioneer as 2", "1 move 100", "2 move 100");
        assertThat(fixture.refusal("2 act " + saved + " with 1"))
                .get()
                .asString()
                .contains("robot 2 is of type pioneer, not aibo");
        assertThat(fixture.runPipe("1 act " + saved + " with 2")).noneMatch(line -> line.contains("failed"));
        assertThat(fixture.team.member(1).name()).isEmpty();
    }

    @Test
    void commandsOfASessionAreRefusedWithTheirPlace() throws Exception {
        String bad = file("bad.majic", "me move 100", "quit", "1-3 move 5", "me act Other");
        assertThat(fixture.refusal("1 act " + bad))
                .get()
                .asString()
                .contains(
                        "bad.majic:2:1: quit: is for a session",
                        "bad.majic:3:1: 1-3: an act names",
                        "bad.majic:4:4: act:");
    }

    @Test
    void ofVeryManyMistakesTheFirstAreReportedAndTheOthersCounted() throws Exception {
        String bad = file("bad.majic", Collections.nCopies(5000, "quit").toArray(String[]::new));
        assertThat(String.join("\n", fixture.runPipe("1 act " + bad)))
                .contains("bad.majic:20:1: quit:", "bad.majic: and 4980 more mistakes")
                .doesNotContain("bad.majic:21:1:");
    }

    @Test
    void aMistakeThatTheRobotShowsIsReportedOnce() throws Exception {
        String bad = file("bad.majic", "me set headPam 3");
        assertThat(fixture.runPipe("1 act " + bad))
                .filteredOn(line -> line.contains("headPam"))
                .hasSize(1);
    }

    @Test
    void ownsTheRobotUntilItEndsOrIsStopped() throws Exception {
        String ahead = file("ahead.majic", "repeat", "me move 100", "end");
        fixture.prompt.parseText("1 act " + ahead);
        fixture.pause(3);
        assertThat(fixture.prompt.parseText("1 move 50"))
                .get()
                .asString()
                .contains("1 is running ahead; \"1 stop\" ends it");
        fixture.prompt.parseText("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.team.member(1).owner()).isNull();
        assertThat(fixture.answers()).anyMatch(line -> line.startsWith("1 act") && line.endsWith("stopped"));
    }

    @Test
    void inAScriptItTakesItsTurnAndCanBeCalledOff() throws Exception {
        String ahead = file("ahead.majic", "repeat", "me move 100", "end");
        assertThat(fixture.runPipe(
                        "repeat 1", "1 act " + ahead, "1 turn 90", "2 move 500", "wait 3s", "1 act off", "end"))
                .noneMatch(line -> line.contains("failed") || line.contains("not run"))
                .contains("1 act off: done");
        assertThat(fixture.bot(1).sent()).containsSubsequence("move 100", "halt", "turn 90");
    }

    @Test
    void aConsentIsTakenBackByTheBeginningOfTheHashOfAFileThatIsGone() throws Exception {
        Path act = nod();
        String hash = ActFile.read(act).sha256();
        fixture.runPipe("trust \"" + act + "\" \"" + hash + '"');
        Files.delete(act);
        String begin = hash.substring(0, 8);
        assertThat(fixture.runPipe("trust off \"" + begin + '"')).contains("trust off " + begin + ": done");
    }

    @Test
    void theListOfRobotsHasTheLastMessageOfAnAct() throws Exception {
        Owner act = new Owner(Owner.Kind.ACT, "Guard", () -> {});
        Member robot = fixture.team.member(1);
        robot.claim(act);
        assertThat(fixture.runPipe("bots")).last().asString().startsWith("2: ");
        assertThat(fixture.answers()).anyMatch(line -> line.startsWith("1: ") && line.endsWith("running Guard"));
        robot.report(act, "watches");
        assertThat(fixture.runPipe("bots"))
                .anyMatch(line -> line.startsWith("1: ") && line.endsWith("running Guard: watches"));
    }

    @Test
    void anUnknownNameIsRefusedWithWhatWouldBeRight() throws Exception {
        assertThat(fixture.refusal("1 act Wandr"))
                .get()
                .asString()
                .contains("there is no act Wandr")
                .contains("\"acts\" lists");
    }

    /** Makes an act that brings code of its own. */
    private Path nod() throws IOException {
        Path source = Files.writeString(
                folder.resolve("Nod.java"),
                "public class Nod extends majic.act.MajicAct { protected void behave() { bot.move(70); } }");
        return Files.write(folder.resolve("nod.act"), ActMaker.from(source).make("Nod", ActDetails.named("Nod")));
    }

    @Test
    void aLineAgreesToTheCodeAndALineTakesItBack() throws Exception {
        Path act = nod();
        String hash = ActFile.read(act).sha256();
        String name = "\"" + act + "\"";
        assertThat(fixture.runPipe("trust " + name + " \"" + hash + "\"", "1 act " + name))
                .anyMatch(line -> line.endsWith("done") && line.startsWith("trust "));
        assertThat(fixture.bot(1).sent()).startsWith("move 70");
        assertThat(fixture.runPipe("trust"))
                .last()
                .asString()
                .matches("trust: Nod since \\d{4}-\\d\\d-\\d\\d, file \\Q" + act + "\\E; to end it: trust off \""
                        + hash.substring(0, 8) + '"');
        assertThat(fixture.runPipe("trust off " + name)).contains("trust off " + act + ": done");
        assertThat(fixture.runPipe("trust")).endsWith("trust: there is no consent to the code of an act");
        assertThat(fixture.refusal("1 act " + name)).get().asString().contains("it brings code of its own");
        assertThat(fixture.runPipe("trust off \"" + hash + "\""))
                .anyMatch(line -> line.endsWith("there was no consent for that file"));
    }

    @Test
    void whenOneOfItsRobotsFailsItEndsForAll() throws Exception {
        String both = file("both.majic", "1 move 5000", "2 move 400", "2 move 400");
        fixture.bot(2).stallAfter(200);
        assertThat(fixture.runPipe("1 act " + both + " with 2"))
                .anyMatch(line -> line.startsWith("1 act") && line.contains("failed"));
        assertThat(fixture.bot(1).sent()).contains("halt");
        assertThat(fixture.team.member(2).owner()).isNull();
    }

    @Test
    void savedInAFileItRunsWithoutAQuestion() throws Exception {
        byte[] saved = ActMaker.save(new ScriptAct("there", "me move 100\nme move -100"), ActDetails.named("There"));
        Path file = Files.write(folder.resolve("there.act"), saved);
        assertThat(fixture.runPipe("1 act \"" + file + '"')).anyMatch(line -> line.contains("there.act\": done"));
        assertThat(fixture.bot(1).sent()).startsWith("move 100", "move -100");
    }
}

package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import majic.act.NoActs;
import majic.bot.BotException;
import majic.bot.FakeType;
import majic.bot.Pose;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SavedTeamTest {
    @AutoClose
    private final ScriptFixture fixture = new ScriptFixture();

    @TempDir
    private Path folder;

    private Path save() throws InterruptedException {
        fixture.runPipe("add sim:aibo as 2", "add sim:pioneer as 1", "1 set pose 1000 500 90", "2 set posture sit");
        Path file = folder.resolve("lab.team");
        fixture.runPipe("save team " + file);
        return file;
    }

    private void open(ScriptFixture again, SavedTeam team, int robots) throws InterruptedException {
        team.open(again.session);
        again.team.changes().await(() -> again.team.members().size() == robots, 100);
        again.pause(1);
    }

    @Test
    void theFileIsAScriptWithAddressesCalibrationsAndStartPoses() throws Exception {
        assertThat(Files.readAllLines(save()))
                .containsExactly(
                        "# robots: 1 Pioneer, 2 Aibo",
                        "add sim:pioneer as 1",
                        "1 set posture stand",
                        "lab place 1 1000 500 90",
                        "add sim:aibo as 2",
                        "2 set posture sit");
    }

    @Test
    void aRobotThatIsGuardedAndGivesWayIsSavedSo() throws InterruptedException {
        fixture.runPipe("add sim:aibo as 2", "2 set guard on", "2 set giveWay on");

        assertThat(fixture.session.teamScript()).contains("2 set guard on\n2 set giveWay on\n");
    }

    @Test
    void theNamesOfTheRobotsAreSavedAndGivenAgain() throws Exception {
        fixture.runPipe("add sim:aibo as 2", "2 name Rex");
        Path file = folder.resolve("names.team");
        fixture.runPipe("save team " + file);
        SavedTeam team = SavedTeam.read(file);
        assertThat(team.names(fixture.factory)).containsExactly("2 Rex (Aibo)");
        try (ScriptFixture again = new ScriptFixture()) {
            open(again, team, 1);
            assertThat(again.team.listing()).isEqualTo("robots: 2 Rex (Aibo)");
            assertThat(again.session.teamScript()).contains("2 name Rex");
        }
    }

    @Test
    void anOpenedTeamHasTheSameRobotsCalibrationsAndPoses() throws Exception {
        Path file = save();
        try (ScriptFixture again = new ScriptFixture()) {
            open(again, SavedTeam.read(file), 2);
            assertThat(again.team.listing()).isEqualTo("robots: 1 Pioneer, 2 Aibo");
            assertThat(again.bot(1).state().pose()).isEqualTo(new Pose(1000, 500, 90));
            assertThat(again.bot(2).get("posture")).hasToString("sit");
            assertThat(again.session.teamScript()).isEqualTo("""
                            # robots: 1 Pioneer, 2 Aibo
                            add sim:pioneer as 1
                            lab place 1 1000 500 90
                            add sim:aibo as 2
                            """);
        }
    }

    @Test
    void theFileCanBeRunAsAScript() throws Exception {
        Path file = save();
        try (ScriptFixture again = new ScriptFixture()) {
            again.runPipe("run " + file);
            assertThat(again.pipe.allSucceeded()).as(again.answers().toString()).isTrue();
            assertThat(again.bot(2).get("posture")).hasToString("sit");
            assertThat(again.bot(1).placedAt()).contains(new Pose(1000, 500, 90));
        }
    }

    @Test
    void aRobotThatIsMissingDoesNotKeepTheOthersAway() throws Exception {
        SavedTeam team = SavedTeam.parse("add sim:dinosaur as 1\n1 set pose 1 2 3\nadd sim:pioneer as 2\n");

        open(fixture, team, 1);
        assertThat(fixture.team.listing()).isEqualTo("robots: 2 Pioneer");
        assertThat(fixture.answers()).anyMatch(line -> line.contains("the lab has no dinosaur"));
    }

    @Test
    void aLineThatCouldMoveARobotIsRefusedBeforeAnythingIsAdded() {
        assertThatThrownBy(() -> SavedTeam.parse("add sim:pioneer as 1\n1 move 500\n"))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("line 2: \"1 move 500\" is no line of a saved team");
    }

    @ParameterizedTest
    @ValueSource(strings = {"add sim:aibo as 2\n\0\0\0", "# Gr\u00FC\u00DFe\n"})
    void aDamagedFileIsKeptWhenTheTeamIsSavedThere(String damage) throws Exception {
        byte[] damaged = damage.getBytes(StandardCharsets.ISO_8859_1);
        Path file = Files.write(folder.resolve("lab.team"), damaged);
        assertThatThrownBy(() -> SavedTeam.read(file)).isInstanceOf(BotException.class);

        save();

        Path kept = folder.resolve("lab.team.damaged");
        assertThat(Files.readAllBytes(kept)).isEqualTo(damaged);
        assertThat(SavedTeam.read(file).names(fixture.factory)).containsExactly("1 Pioneer", "2 Aibo");
        assertThat(fixture.answers())
                .anyMatch(line -> line.contains(": done; the file that was there is damaged and is kept as " + kept));
    }

    @Test
    void anEarlierTeamIsReplaced() throws Exception {
        save();
        save();
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).hasSize(1);
        }
    }

    @Test
    void aSettingThatIsNoCalibrationIsNotMade() throws Exception {
        open(fixture, SavedTeam.parse("add sim:pioneer as 1\n1 set headPan 30\n"), 1);

        assertThat(fixture.bot(1).sent()).isEmpty();
        assertThat(fixture.answers()).anyMatch(line -> line.startsWith("1 set headPan 30: a saved team sets"));
    }

    @Test
    void aFileWithoutRobotsIsRefused() throws Exception {
        Path file = Files.writeString(folder.resolve("empty.team"), "# nothing\n");

        assertThatThrownBy(() -> SavedTeam.read(file)).hasMessageEndingWith("there is no robot in this team");
    }

    @Test
    void anEmptyTeamIsNotSaved() throws Exception {
        assertThat(fixture.runPipe("save team " + folder.resolve("empty.team")))
                .anyMatch(line -> line.contains("there are no robots yet"));
    }

    @Test
    void theRobotsAreNamedByNumberAndType() {
        SavedTeam team = SavedTeam.parse("add sim:pioneer2 as 1\nadd \"aibo://10.0.0.5\" as 4\nadd cat:x as 5\n");

        assertThat(team.names(fixture.factory)).containsExactly("1 Pioneer", "4 Aibo", "5 cat");
        assertThat(team.needsLab()).isTrue();
    }

    /** Its desk keeps the place: opening the team would set it there, for all desks. */
    @Test
    void thePlaceOfARobotOfAnotherDeskIsNotSaved() throws Exception {
        Path file = folder.resolve("shared.team");
        try (Team team = new Team(TimeSource.system())) {
            BotFactory factory = new BotFactory(List.of(new FakeType("mqtt")), Settings.inMemory());
            Session session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
            MajicParser parser = MajicParser.pipe(session);
            parser.parseText("add mqtt://broker/lab/desk2/1 as 1");
            parser.parseText("1 set pose 1000 500 90");
            parser.parseText("save team " + file);
            parser.awaitAll();

            assertThat(team.member(1).bot().placedAt()).contains(new Pose(1000, 500, 90));
        }
        assertThat(Files.readString(file))
                .contains("add mqtt://broker/lab/desk2/1 as 1")
                .doesNotContain("pose");
    }
}

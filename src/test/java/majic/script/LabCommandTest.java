package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The commands for the simulated lab. */
class LabCommandTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @Test
    void theListHasTruePosesAndBumps() throws InterruptedException {
        assertThat(fixture.runPipe("lab")).containsExactly("lab: aibo x=1234 y=0 heading=0.0 bumps=2");
    }

    @Test
    void aPlacedRobotReportsThatPose() throws InterruptedException {
        assertThat(fixture.runPipe("lab place 2 1m 500 -90", "2 wait")).containsExactly("2 lab place 1m 500 -90: done");
        assertThat(fixture.bot(2).state().pose()).isEqualTo(new Pose(1000, 500, -90));
    }

    @Test
    void aRobotIsPlacedInItsTurn() throws InterruptedException {
        assertThat(fixture.runPipe("2 move 300", "lab place 2 1000 500 90", "2 get x"))
                .satisfiesExactly(
                        moved -> assertThat(moved).startsWith("2 move 300: done"),
                        placed -> assertThat(placed).isEqualTo("2 lab place 1000 500 90: done"),
                        read -> assertThat(read).isEqualTo("2 x = 1000 mm"));
    }

    @Test
    void aPlaceThatIsTakenIsAFailureAndTheRobotKeepsItsPose() throws InterruptedException {
        assertThat(fixture.runPipe("lab place 2 -1000 0 0", "2 wait"))
                .contains("2 lab place -1000 0 0: failed: a wall or another robot is there");
        assertThat(fixture.bot(2).placedAt()).isEmpty();
    }

    @Test
    void aRobotThatIsNotInTheLabIsRefused() throws InterruptedException {
        MajicBot real = (FakeBot) fixture.factory.create("pioneer://10.0.0.5");
        real.connect();
        fixture.team.add(real, OptionalInt.empty());

        assertThat(fixture.refusal("lab place 3 0 0 0"))
                .contains(
                        "lab place: robot 3 is not in the simulated lab; \"3 set pose\" sets the pose that a real robot reports");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    lab place         | behind "place" a robot (a number, a name, a range, a type, all) is missing
                    lab place 2       | behind "2" a distance (mm, cm, m) is missing
                    lab place 2 1 1   | behind "1" an angle (deg, rad) is missing
                    lab place 7 1 1 0 | 7: there is no robot 7 (robots: 1 Aibo, 2 Pioneer)
                    lab plaice        | plaice: nothing more is expected behind "lab"
                    """)
    void aWrongLineSaysWhatIsMissing(String line, String why) throws InterruptedException {
        assertThat(fixture.refusal(line)).isEqualTo(Optional.of(why));
    }

    @Test
    void aSavedSessionPlacesTheRobotAgain() throws InterruptedException {
        fixture.runPipe("lab place 2 1000 500 90", "2 wait", "2 move 300");

        assertThat(fixture.session.state().record().lines())
                .containsSubsequence("lab place 2 1000 500 90", "2 move 300");
    }
}

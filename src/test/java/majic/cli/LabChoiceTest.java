package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.Set;
import majic.program.UsageException;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.options.Dialect;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class LabChoiceTest {
    private final LabChoice choice = new LabChoice();
    private final CommandLine line = new CommandLine(new Options(choice));

    @Test
    void thePioneersModelIsChosenInAnyCase() throws IOException {
        line.parseArgs("--pioneer-model", "P3AT-sh");
        assertThat(choice.options().pioneerModel()).isEqualTo("p3at-sh");
        assertThat(choice.isGiven()).isTrue();
    }

    @Test
    void withoutAChoiceItIsTheStandardOne() throws IOException {
        line.parseArgs();
        assertThat(choice.options().pioneerModel()).isEqualTo("p3dx-sh");
        assertThat(choice.isGiven()).isFalse();
    }

    @Test
    void aModelThatIsNoneIsRefusedWithTheListOfThoseThereAre() {
        line.parseArgs("--pioneer-model", "r2d2");
        assertThatThrownBy(choice::options)
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith("--pioneer-model r2d2: there is no Pioneer model 'r2d2'; known are p3dx, ");
    }

    @Test
    void thePioneersAreCounted() throws IOException {
        line.parseArgs("--pioneers", "3");
        assertThat(choice.options().pioneers()).isEqualTo(3);
        assertThat(choice.isGiven()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "501", "-1"})
    void aNumberOfPioneersThatCannotBeIsRefused(String count) {
        line.parseArgs("--pioneers", count);
        assertThatThrownBy(choice::options)
                .isInstanceOf(UsageException.class)
                .hasMessage("--pioneers " + count + ": outside 1 … 500");
    }

    @Test
    void manyPioneersStandInAHallThatHasTheSpace() throws IOException {
        line.parseArgs("--pioneers", "500");

        assertThat(choice.options().room().homes(502)).hasSize(502).doesNotHaveDuplicates();
    }

    @Test
    void ninePioneersStandInTheStandardRoom() throws IOException {
        line.parseArgs("--pioneers", "9");

        assertThat(choice.options().room().bounds()).isEqualTo(Room.standard().bounds());
    }

    @Test
    void theHemissonIsChosenByWords() throws IOException {
        line.parseArgs("--hemisson-model", "RoadNarrows+camera+switches=1110+overrun");
        assertThat(choice.options().hemisson())
                .isEqualTo(HemissonOptions.standard()
                        .withDialect(Dialect.ROADNARROWS)
                        .withModules(Set.of(ModuleKind.CAMERA))
                        .withSwitches("1110")
                        .withOverrun());
        assertThat(choice.isGiven()).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "khepera | there is no 'khepera' for a Hemisson; known are kteam or roadnarrows, then +camera ",
                "kteam+gripper | there is no 'gripper' for a Hemisson",
                "kteam+switches=11 | switches must be four characters 0 or 1, not '11'",
                "kteam+ambient=256 | ambient must be 0 (bright) to 255 (dark), not 256",
                "kteam+mismatch=much | mismatch must be a number, not 'much'",
                "kteam+mismatch=51 | mismatch must be -50 to 50 percent, not 51.0",
            })
    void aHemissonThatIsNoneIsRefusedWithTheReason(String model, String reason) {
        line.parseArgs("--hemisson-model", model);
        assertThatThrownBy(choice::options)
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith("--hemisson-model " + model + ": " + reason);
    }

    @Test
    void aRoverIsTheUsualMavlinkVehicle() throws IOException {
        line.parseArgs("--mavlink", "--exact");
        assertThat(choice.options().mavlink()).isEqualTo(MavlinkOptions.parse("rover"));
        assertThat(choice.options().robots()).isEqualTo(4);
        assertThat(choice.isGiven()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"copter", "rover,copter", "boat+ready,copter+udp=14550"})
    void mavlinkVehiclesAreChosenByWords(String models) throws IOException {
        line.parseArgs("--mavlink=" + models);
        assertThat(choice.options().mavlink()).isEqualTo(MavlinkOptions.parse(models));
        line.parseArgs("--mavlink", models);
        assertThat(choice.options().mavlink()).isEqualTo(MavlinkOptions.parse(models));
    }

    @Test
    void aMavlinkVehicleThatIsNoneIsRefusedWithTheReason() {
        line.parseArgs("--mavlink=rover+fast");
        assertThatThrownBy(choice::options)
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith(
                        "--mavlink rover+fast: there is no 'fast' for a MAVLink vehicle; known are rover, ");
    }

    @Test
    void theHelpListsTheModels() {
        assertThat(line.getUsageMessage()).contains("amigo-sh", "powerbot-sh", "pioneer-lx");
    }

    @CommandLine.Command
    private static final class Options {
        @CommandLine.Mixin
        private final LabChoice choice;

        Options(LabChoice choice) {
            this.choice = choice;
        }
    }
}

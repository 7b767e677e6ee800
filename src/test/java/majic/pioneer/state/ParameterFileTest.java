package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.BotException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ParameterFileTest {
    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void name() {
        file = folder.resolve("own.p");
    }

    private ParameterFile read(String text) throws IOException {
        return ParameterFile.read(Files.writeString(file, text));
    }

    @Test
    void aWholeFileDescribesAModelThatNoTableHas() throws IOException {
        Model model = read("""
                ConfigVersion 2.0
                ;  Robot parameter file

                Section General settings
                Class Pioneer            ; general type of robot
                Subclass p9xl            ; specific type of robot
                RobotWidth 680.00000     ; width in mm
                RobotLength 911.00000    ; length in mm of the whole robot
                RobotLengthFront 369.00000 ; length in mm to the front of the robot (if this is
                                         ; 0 this value will be half of RobotLength)
                RobotLengthRear 542.00000
                MaxRVelocity 360         ; absolute maximum degrees / sec
                MaxVelocity 2000         ; absolute maximum mm / sec
                Section Conversion factors
                AngleConvFactor 0.00614  ; radians per angular unit
                DistConvFactor 0.05066   ; multiplier to mm from robot units
                VelConvFactor 2.53320    ; multiplier to mm/sec from robot units
                RangeConvFactor 0.17340  ; multiplier to mm from sonar units
                DiffConvFactor 0.00373   ; ratio of angular velocity to wheel velocity
                Vel2Divisor 20.00000
                FrontBumpers true
                NumFrontBumpers 7
                RearBumpers false
                ;  IRUnit <IR Number> <IR Type> <x position, mm> <y
                 position, mm>
                SonarNum 3
                SonarUnit 0 152 278 90
                SonarUnit 7 0 0 -180
                SonarUnit 30 -298 278 90 0 0 0 0 0 true
                LaserIgnore
                """).model("p9xl");

        assertThat(model.known()).isTrue();
        assertThat(model.hull()).isEqualTo(new Hull(369, 542, 340));
        assertThat(model.scaling()).isEqualTo(new Scaling(0.05066, 360.0 / 1024, 2.5332, 0.1734, 0.00373));
        assertThat(List.of(model.topSpeedMmPerSec(), model.topTurnDegPerSec())).isEqualTo(List.of(2000.0, 360.0));
        assertThat(List.of(model.frontBumpers(), model.rearBumpers())).isEqualTo(List.of(7, 0));
        assertThat(model.discs()).isEqualTo(List.of(new SonarDisc(0, 152, 278, 90), new SonarDisc(30, -298, 278, 90)));
    }

    @Test
    void aFileOfAFewLinesChangesOnlyThese() throws IOException {
        Model model = read("distconvfactor 0.58\r\nAngleConvFactor 0.0018\r\n").model("p3dx");
        Model table = Models.of("p3dx");

        assertThat(model.scaling().mmPerCount()).isEqualTo(0.58);
        assertThat(model.scaling().degPerCount()).isCloseTo(Math.toDegrees(0.0018), within(1e-9));
        assertThat(model.scaling().countsPerTurn()).isEqualTo(4096);
        assertThat(model.hull()).isEqualTo(table.hull());
        assertThat(model.discs()).isEqualTo(table.discs());
        assertThat(model.topSpeedMmPerSec()).isEqualTo(table.topSpeedMmPerSec());
    }

    @Test
    void anUnknownModelWithItsScaleOnlyIsDrivenCarefully() throws IOException {
        Model model = read("DistConvFactor 0.5813\n").model("p9xl");

        assertThat(model.scaling()).isEqualTo(new Scaling(0.5813, Scaling.DEG_PER_UNIT, 1, 1, 0.0056));
        assertThat(model.topSpeedMmPerSec()).isEqualTo(300);
        assertThat(model.discs()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "DistConvFactor 0,'DistConvFactor needs a number from 0.000001 to 100, not 0'",
        "DistConvFactor -1,'DistConvFactor needs a number from 0.000001 to 100, not -1'",
        "DistConvFactor NaN,'DistConvFactor needs a number from 0.000001 to 100, not NaN'",
        "'DistConvFactor 0,485','DistConvFactor needs a number from 0.000001 to 100, not 0,485'",
        "DistConvFactor,'DistConvFactor needs a number from 0.000001 to 100, not nothing'",
        "RobotWidth wide,'RobotWidth needs a number from 1 to 10000, not wide'",
        "SonarUnit 0 1 2,'SonarUnit needs the number of the disc, x mm, y mm and degrees, as in \"SonarUnit 0 69 136 90\"'",
        "SonarUnit 32 1 2 3,'SonarUnit needs a number from 0 to 31, not 32'"
    })
    void aWrongLineIsNamedWithItsFile(String line, String problem) {
        assertThatThrownBy(() -> read("; the lab's robot\n" + line + "\nDistConvFactor 1"))
                .isInstanceOf(BotException.class)
                .hasMessage(file + ", line 2: " + problem);
    }

    @Test
    void aFileWithoutTheScaleIsRefused() {
        assertThatThrownBy(() -> read("Section General settings\n"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining(file + ": has no line such as \"DistConvFactor 0.485\"");
    }

    @Test
    void aFolderIsRefused() {
        assertThatThrownBy(() -> ParameterFile.read(folder)).hasMessageContaining("it is a folder");
    }
}

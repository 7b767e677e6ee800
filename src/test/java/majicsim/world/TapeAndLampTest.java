package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.StringReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TapeAndLampTest {
    @ParameterizedTest
    @CsvSource({"500,0,0.08", "500,9.5,0.54", "500,12,1", "1000,400,0.08", "1012,400,1", "500,200,1", "-12,0,1"})
    void theFloorIsBlackOverTapeAndWhiteBesideIt(double x, double y, double reflectivity) throws IOException {
        World world = world("Cairn: Tape 0 0 0 \"\" ICON \"a line\" 0 0 1000 0 1000 500");
        assertThat(world.floorReflectivity(x, y)).isCloseTo(reflectivity, within(0.001));
    }

    @Test
    void aTapesPointsTurnWithItsCairn() throws IOException {
        World world = world("Cairn: Tape 0 0 90 \"\" ICON \"a line\" 0 0 1000 0");
        assertThat(world.floorReflectivity(0, 500)).isCloseTo(0.08, within(1e-6));
        assertThat(world.floorReflectivity(500, 0)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "ICON \"a line\" 0 0 | m.map:2: a tape needs two points or more: x1 y1 x2 y2 ... after its name in quotes",
                "0 0 1000 0 | m.map:2: a tape needs two points or more: x1 y1 x2 y2 ... after its name in quotes",
                "ICON \"a line\" 0 0 1000 0 5 | m.map:2: y is missing",
            })
    void aTapeWithoutPointsIsRefused(String cairn, String message) {
        assertThatThrownBy(() -> world("Cairn: Tape 0 0 0 " + cairn)).hasMessage(message);
    }

    @Test
    void aSensorThatLooksAtTheLampSeesMoreOfItTheNearerItIs() throws IOException {
        World world = world("Cairn: Lamp 0 0 0 \"\" ICON \"lamp\"");
        double far = world.lampLight(new Pose(-2000, 0, 0));
        double near = world.lampLight(new Pose(-500, 0, 0));
        double away = world.lampLight(new Pose(-500, 0, 180));
        assertThat(near).isGreaterThan(far * 5).isGreaterThan(away * 2);
        assertThat(far).isGreaterThan(0.02);
        assertThat(world.lampLight(new Pose(-2500, 0, 0))).isZero();
    }

    @Test
    void aWallThrowsAShadow() throws IOException {
        World world = world("Cairn: Lamp 4500 0 0 \"\" ICON \"lamp beyond the wall\"");
        assertThat(world.lampLight(new Pose(3500, 0, 0))).isZero();
        assertThat(world.ambientLight(3500, 0)).isEqualTo(0.15);
    }

    @Test
    void theStandardRoomHasALineAndLampsAndNeitherAtARobotsHome() {
        World world = new World(Room.standard());
        assertThat(world.room().tapes()).hasSize(1);
        assertThat(world.room().lamps()).hasSize(2);
        for (Pose home : world.room().homes()) {
            assertThat(world.ambientLight(home.xMm(), home.yMm())).isEqualTo(0.15);
            assertThat(world.floorReflectivity(home.xMm(), home.yMm())).isEqualTo(1);
        }
    }

    /** A room of 8 m around the origin. */
    private static World world(String cairn) throws IOException {
        String map = "2D-Map\n" + cairn
                + "\nLINES\n-4000 -4000 4000 -4000\n4000 -4000 4000 4000\n4000 4000 -4000 4000\n-4000 4000 -4000 -4000\n";
        return new World(Room.parse(new StringReader(map), "m.map"));
    }
}

package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RayTest {
    private final World world = new World(Rooms.square(2000));
    private final Body viewer = Body.disc("viewer", 100, new Pose(0, 0, 0));

    @Test
    void aRaySeesTheWallSquareOn() {
        assertThat(world.ray(viewer, 0, 0, 0, 5000)).isEqualTo(new Hit(2000, 1, 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-60, -30, 15, 45})
    void squarenessIsTheCosineOfTheAngleToTheWallsNormal(double direction) {
        Hit hit = world.ray(viewer, 1900, 0, direction, 5000);
        assertThat(hit.squareness()).isCloseTo(Math.cos(Math.toRadians(direction)), within(1e-9));
        assertThat(hit.distanceMm()).isCloseTo(100 / Math.cos(Math.toRadians(direction)), within(1e-6));
    }

    @Test
    void aRayThatEndsInTheAirFindsNothing() {
        Hit hit = world.ray(viewer, 0, 0, 0, 1500);
        assertThat(hit.found()).isFalse();
        assertThat(hit.distanceMm()).isEqualTo(1500);
    }

    @Test
    void aRaySeesOtherBodiesButNotItsOwn() {
        world.add(viewer);
        world.add(Body.box("box", 100, 100, 100, new Pose(700, 0, 0)));
        world.add(Body.disc("disc", 100, new Pose(0, 700, 0)));
        assertThat(world.ray(viewer, 0, 0, 0, 5000).distanceMm()).isCloseTo(600, within(1e-6));
        assertThat(world.ray(viewer, 0, 0, 90, 5000).distanceMm()).isCloseTo(600, within(1e-6));
        assertThat(world.ray(viewer, 50, 0, 90, 5000).distanceMm()).isCloseTo(613.397, within(1e-3));
    }

    @Test
    void aRayAcrossTheWholeRoomFindsTheWallWhereverTheIndexCutsIt() {
        World big = new World(Rooms.square(20_000));
        for (int direction = 0; direction < 360; direction += 7) {
            double angle = Math.toRadians(direction);
            double expected = 20_000 / Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
            assertThat(big.ray(viewer, 0, 0, direction, 60_000).distanceMm()).isCloseTo(expected, within(1e-3));
        }
    }
}

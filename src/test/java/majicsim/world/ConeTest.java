package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Tests that a sensor with a cone measures in the part of the room that it looks up what it would measure in all of it.
 */
class ConeTest {
    private static final int ROBOTS = 60;
    private static final double HALF_DEG = 15;
    private static final double LENGTH_MM = 5000;
    private static final int CONES = 2000;

    private final Random random = new Random(1);
    private final Room room = Room.forRobots(ROBOTS);
    private final World world = new World(room);
    private Body viewer = Body.disc("viewer", 1, new Pose(0, 0, 0));

    @BeforeEach
    void fillTheRoom() {
        for (Pose home : room.homes(ROBOTS)) {
            viewer = Body.box("robot", 200, 250, 190, new Pose(home.xMm(), home.yMm(), random.nextDouble(360)));
            world.add(viewer);
        }
    }

    @Test
    void aRayInAConeMeetsWhatARayOfTheSameDirectionMeets() {
        int found = 0;
        for (int count = 0; count < CONES; count++) {
            Pose axis = somewhere();
            View cone = world.view(viewer, new Cone(axis, HALF_DEG, LENGTH_MM));
            View all = world.view(viewer, new Point(axis.xMm(), axis.yMm()), LENGTH_MM);
            for (double aside = -HALF_DEG; aside <= HALF_DEG; aside += 2.5) {
                Hit hit = cone.ray(axis.headingDeg() + aside, LENGTH_MM);
                assertThat(hit).isEqualTo(all.ray(axis.headingDeg() + aside, LENGTH_MM));
                found += hit.found() ? 1 : 0;
            }
        }
        assertThat(found).isGreaterThan(CONES);
    }

    @Test
    void allCornersInAConeArePassedOn() {
        for (int count = 0; count < CONES; count++) {
            Pose axis = somewhere();
            List<Point> corners = new ArrayList<>();
            world.view(viewer, new Cone(axis, HALF_DEG, LENGTH_MM)).cornersNear(LENGTH_MM / 2, corners::add);
            assertThat(corners).containsAll(cornersIn(axis));
        }
    }

    private Pose somewhere() {
        Bounds all = room.bounds();
        return new Pose(
                random.nextDouble(all.minX(), all.maxX()),
                random.nextDouble(all.minY(), all.maxY()),
                random.nextDouble(360));
    }

    private List<Point> cornersIn(Pose axis) {
        List<Point> corners = new ArrayList<>();
        room.walls().forEach(wall -> corners.add(new Point(wall.x1(), wall.y1())));
        world.bodies().stream().filter(body -> body != viewer).forEach(body -> corners.addAll(body.outline()));
        corners.removeIf(corner -> !isIn(axis.toLocal(corner)));
        return corners;
    }

    private static boolean isIn(Point local) {
        double distance = Math.hypot(local.xMm(), local.yMm());
        return distance < LENGTH_MM / 2 && Math.abs(Math.toDegrees(Math.atan2(local.yMm(), local.xMm()))) < HALF_DEG;
    }
}

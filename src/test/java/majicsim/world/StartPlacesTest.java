package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StartPlacesTest {
    private static final double WIDEST_MM = 200;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void eachRobotOfTheStandardRoomHasItsFreeLaneAheadAndBehind(int robot) {
        World world = new World(Room.standard());
        addAllBut(robot, world);
        Pose home = world.room().home(robot);
        Body lane = Body.box("lane", 210 + 1500, 301 + 1500, WIDEST_MM, home);
        assertThat(world.isFree(lane, home)).isTrue();
    }

    @Test
    void placesAreFoundWhereTheMapNamesTooFew() {
        Room room = Rooms.square(3000);
        World world = new World(room);
        for (int robot = 1; robot <= 3; robot++) {
            world.add(Body.box("robot " + robot, 1800, 1800, 300, room.home(robot)));
        }
        assertThat(world.bodies()).hasSize(3);
    }

    @Test
    void placesStayOnTheSeedsSideOfAWall() {
        Room room = new Room(
                List.of(
                        new Segment(-9000, 0, 9000, 0, 1),
                        new Segment(-9000, 4000, 9000, 4000, 1),
                        new Segment(-9000, -4000, 9000, -4000, 1)),
                List.of(new Pose(0, 2000, 0)),
                List.of(),
                RoomContents.NONE);
        assertThat(room.home(2).yMm()).isPositive();
        assertThat(room.home(3).yMm()).isPositive();
    }

    @Test
    void aLargeMapWithoutPlacesHoldsManyRobots() {
        World world = new World(Rooms.square(20_000));
        List<Pose> homes = world.room().homes(100);
        for (Pose home : homes) {
            world.add(Body.box("robot", 210, 301, WIDEST_MM, home));
        }
        assertThat(homes).startsWith(world.room().home(1), world.room().home(2));
    }

    @Test
    void eachRobotOfAHallCanDriveAMetre() {
        World world = new World(Room.forRobots(100));
        List<Pose> homes = world.room().homes(100);
        homes.forEach(home -> world.add(Body.box("robot", 210, 301, WIDEST_MM, home)));
        world.bodies().forEach(body -> body.velocity(1000, 0));
        for (int step = 0; step < 250; step++) {
            world.step(0.004);
        }
        assertThat(world.bodies()).noneMatch(Body::blocked);
    }

    @Test
    void aRoomThatIsTooSmallIsRefused() {
        assertThatThrownBy(() -> Rooms.square(300).home(1)).hasMessage("the map has no free place left for robot 1");
    }

    private static void addAllBut(int robot, World world) {
        for (int other = 1; other <= 3; other++) {
            if (other != robot) {
                world.add(Body.box(
                        "robot " + other, 210, 301, WIDEST_MM, world.room().home(other)));
            }
        }
    }
}

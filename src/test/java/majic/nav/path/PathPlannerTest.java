package majic.nav.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import majic.bot.Fence;
import majic.bot.Pose;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.NavigationMap.ForbiddenLine;
import majic.nav.grid.OccupancyGrid;
import org.junit.jupiter.api.Test;

/** Ways across a floor of 10 m by 10 m that a wall at x = 5000 mm divides, with a door from y = 7000 to 8000 mm. */
class PathPlannerTest {
    private static final double CELL_MM = 50;
    private static final double FREE = 0.02;
    private static final double WALL = 0.98;
    private static final Pose LEFT = new Pose(2000, 2000, 0);
    private static final Pose RIGHT = new Pose(8000, 2000, 0);
    private static final Pose DOOR = new Pose(5000, 7500, 0);

    private static OccupancyGrid floor(OccupancyGrid.Cells cells) {
        return OccupancyGrid.of(Pose.START, CELL_MM, 200, 200, cells);
    }

    private static boolean isWall(int column, int row) {
        return column >= 99 && column <= 100 && (row < 140 || row >= 160);
    }

    private static final NavigationMap MAP =
            NavigationMap.of(floor((column, row) -> isWall(column, row) ? WALL : FREE));

    private static FreeSpace space(double bodyMm, FreeSpace.Disc... things) {
        return new FreeSpace(new ObstacleDistance(MAP), bodyMm, List.of(things));
    }

    private static double leastRoomMm(FreeSpace space, Way way) {
        double least = Double.POSITIVE_INFINITY;
        for (double mm = 0; mm <= way.lengthMm(); mm += 20) {
            least = Math.min(least, space.mm(way.at(mm).xMm(), way.at(mm).yMm()));
        }
        return least;
    }

    @Test
    void aWayLeadsThroughTheDoorAndKeepsClearOfTheWalls() {
        FreeSpace space = space(300);
        Way way = new PathPlanner(space).plan(LEFT, RIGHT).orElseThrow();

        assertThat(way.points().get(0).distanceMm(LEFT)).isZero();
        assertThat(way.end().distanceMm(RIGHT)).isZero();
        assertThat(leastRoomMm(space, way)).isGreaterThan(FreeSpace.MARGIN_MM / 2);
        double shortest = LEFT.distanceMm(DOOR) + DOOR.distanceMm(RIGHT);
        assertThat(way.lengthMm()).isBetween(0.95 * shortest, 1.05 * shortest);
    }

    @Test
    void aStraightWayHasNoCorners() {
        Way way =
                new PathPlanner(space(300)).plan(LEFT, new Pose(2000, 9000, 0)).orElseThrow();

        assertThat(way.points()).hasSize(2);
        assertThat(way.end().headingDeg()).isCloseTo(90, within(0.01));
    }

    @Test
    void aRobotThatIsWiderThanTheDoorHasNoWay() {
        assertThat(new PathPlanner(space(500)).plan(LEFT, RIGHT)).isEmpty();
    }

    @Test
    void aThingInTheDoorClosesIt() {
        FreeSpace space = space(300, new FreeSpace.Disc(5000, 7500, 200));

        assertThat(new PathPlanner(space).plan(LEFT, RIGHT)).isEmpty();
        assertThat(new PathPlanner(space.with(List.of())).plan(LEFT, RIGHT)).isPresent();
    }

    @Test
    void aForbiddenLineIsNotCrossed() {
        NavigationMap map = new NavigationMap(
                MAP.grid(), List.of(), List.of(new ForbiddenLine(5000, 7000, 5000, 8000)), Optional.empty());
        FreeSpace space = new FreeSpace(new ObstacleDistance(map), 300, List.of());

        assertThat(new PathPlanner(space).plan(LEFT, RIGHT)).isEmpty();
    }

    @Test
    void aFenceIsNotLeft() {
        Pose right = new Pose(6000, 5000, 0);
        FreeSpace wide = new FreeSpace(new ObstacleDistance(MAP), 300, List.of(), new Fence(5000, 5000, 3500));
        FreeSpace narrow = new FreeSpace(wide.map(), 300, List.of(), new Fence(5000, 5000, 2000));

        Way way = new PathPlanner(wide).plan(new Pose(4000, 5000, 0), right).orElseThrow();
        assertThat(way.points())
                .allSatisfy(point ->
                        assertThat(wide.isInFence(point.xMm(), point.yMm())).isTrue());
        assertThat(new PathPlanner(narrow).plan(new Pose(4000, 5000, 0), right)).isEmpty();
        assertThat(new PathPlanner(narrow.unfenced()).plan(new Pose(4000, 5000, 0), right))
                .isPresent();
    }

    @Test
    void aRobotThatIsALittleOutsideOfItsFenceComesBack() {
        FreeSpace space = new FreeSpace(new ObstacleDistance(MAP), 300, List.of(), new Fence(2000, 5000, 1500));

        assertThat(new PathPlanner(space).plan(new Pose(2000, 6700, 0), new Pose(2000, 5000, 0)))
                .isPresent();
    }

    @Test
    void whatIsUnknownIsNotCrossed() {
        NavigationMap map = NavigationMap.of(
                floor((column, row) -> isWall(column, row) ? WALL : column > 100 && column < 120 ? Double.NaN : FREE));

        assertThat(new PathPlanner(new FreeSpace(new ObstacleDistance(map), 300, List.of())).plan(LEFT, RIGHT))
                .isEmpty();
    }

    @Test
    void aRobotThatStandsTooCloseToAWallCanLeaveIt() {
        Pose atTheWall = new Pose(4690, 2000, 0);

        assertThat(new PathPlanner(space(300)).plan(atTheWall, LEFT)).isPresent();
    }

    @Test
    void aPlaceInARoomWithoutADoorHasNoWayAlsoBesideItsWall() {
        NavigationMap walled = NavigationMap.of(floor((column, row) -> column >= 99 && column <= 100 ? WALL : FREE));
        FreeSpace space = new FreeSpace(new ObstacleDistance(walled), 300, List.of());
        Pose atTheWall = new Pose(4690, 2000, 0);

        assertThat(new PathPlanner(space).plan(LEFT, RIGHT)).isEmpty();
        assertThat(new PathPlanner(space).plan(atTheWall, RIGHT)).isEmpty();
        assertThat(new PathPlanner(space).plan(atTheWall, new Pose(2000, 9000, 0)))
                .isPresent();
    }

    @Test
    void whatOnePlanFoundDoesNotChangeTheNextOne() {
        FreeSpace space = space(300);
        Way way = new PathPlanner(space).plan(LEFT, RIGHT).orElseThrow();
        new PathPlanner(space.with(List.of(new FreeSpace.Disc(5000, 7500, 200)))).plan(LEFT, RIGHT);
        new PathPlanner(new FreeSpace(space.map(), 500, List.of())).plan(LEFT, RIGHT);

        assertThat(new PathPlanner(space).plan(LEFT, RIGHT)).contains(way);
    }

    @Test
    void inTrafficOppositeWaysThroughACorridorKeepApart() {
        NavigationMap corridor = NavigationMap.of(
                OccupancyGrid.of(Pose.START, CELL_MM, 200, 42, (column, row) -> row == 0 || row == 41 ? WALL : FREE));
        FreeSpace space = new FreeSpace(new ObstacleDistance(corridor), 300, List.of());
        Pose west = new Pose(1000, 1050, 0);
        Pose east = new Pose(9000, 1050, 0);
        Way there = new PathPlanner(space, true).plan(west, east).orElseThrow();
        Way back = new PathPlanner(space, true).plan(east, west).orElseThrow();

        assertThat(there.at(there.lengthMm() / 2).yMm()).isLessThan(700);
        assertThat(back.at(back.lengthMm() / 2).yMm()).isGreaterThan(1400);
    }

    @Test
    void theNearestOfManyPlacesIsFound() {
        Way way = new PathPlanner(space(300))
                .planToNearest(LEFT, 20_000, place -> place.xMm() > 6000)
                .orElseThrow();

        assertThat(way.end().xMm()).isBetween(6000.0, 6300.0);
        assertThat(way.end().yMm()).isBetween(6500.0, 8000.0);
        assertThat(new PathPlanner(space(300)).planToNearest(LEFT, 2000, place -> place.xMm() > 6000))
                .isEmpty();
    }

    @Test
    void theDistancesAreExactAlsoInATurnedMap() {
        OccupancyGrid grid =
                floor((column, row) -> column == 20 && row == 30 ? WALL : FREE).movedInto(new Pose(1000, -2000, 30));
        ObstacleDistance distance = new ObstacleDistance(NavigationMap.of(grid));
        Pose obstacle = grid.centre(20, 30);
        Pose away = grid.centre(50, 70);

        assertThat(distance.mm(away.xMm(), away.yMm()))
                .isCloseTo(obstacle.distanceMm(away), within(1.0))
                .isCloseTo(2500, within(1.0));
        assertThat(distance.mm(-50_000, 0)).isInfinite();
    }

    @Test
    void aRobotSeesHowFarAnArcIsFree() {
        FreeSpace space = space(300);

        assertThat(space.freeMm(new Pose(2000, 2000, 0), 0, 5000)).isCloseTo(2650, within(60.0));
        assertThat(space.freeMm(new Pose(2000, 2000, 90), 0, 5000)).isEqualTo(5000);
    }

    @Test
    void theRestOfAWayBeginsBesideTheRobot() {
        Way way = Way.through(List.of(new Pose(0, 0, 0), new Pose(1000, 0, 0), new Pose(1000, 1000, 0)));
        Way rest = way.from(new Pose(1050, 500, 0));

        assertThat(rest.points().get(0)).isEqualTo(new Pose(1000, 500, 90));
        assertThat(rest.lengthMm()).isCloseTo(500, within(0.1));
        assertThat(way.at(1500)).isEqualTo(new Pose(1000, 500, 90));
    }
}

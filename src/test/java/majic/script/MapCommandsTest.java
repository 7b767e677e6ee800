package majic.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import majic.bot.Beam;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeSensor;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import majic.nav.mapping.Floor;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The commands for the map of the team, with a robot that drives around a ring of corridors. */
class MapCommandsTest {
    private static final int FIRST_CORRIDOR = 100;

    @TempDir
    private Path folder;

    @AutoClose
    private final ScriptFixture fixture = new ScriptFixture();

    private final Floor floor = Floor.ring(1);
    private final List<Pose> way = Floor.around(1);
    private FakeBot robot;

    @BeforeEach
    void addARobotWithALaser() {
        robot = fixture.add(fixture.pioneer);
        robot.equip(Floor.LASER);
    }

    private void drive(List<Pose> odometry) throws InterruptedException {
        drive(robot, way, odometry);
    }

    private void drive(FakeBot bot, List<Pose> truth, List<Pose> odometry) throws InterruptedException {
        for (int step = 0; step < odometry.size(); step++) {
            bot.measure(floor.scan(Floor.LASER, fixture.time.nanos() / 1e9, truth.get(step), odometry.get(step)));
            fixture.pause(0.1);
        }
    }

    /** A second robot, in a map that the first one has built. */
    private FakeBot onTheMap() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way);
        fixture.runPipe("map stop");
        FakeBot other = fixture.add(fixture.pioneer);
        other.equip(Floor.LASER);
        return other;
    }

    private NavigationMap map() {
        return fixture.session.map().get().orElseThrow();
    }

    /** Whether a wall is within a cell of a place. */
    private boolean isWall(double xMm, double yMm) {
        return Stream.of(-50, 0, 50)
                .anyMatch(aside -> map().grid().stateAt(xMm + aside, yMm) == State.OCCUPIED
                        || map().grid().stateAt(xMm, yMm + aside) == State.OCCUPIED);
    }

    @Test
    void aRobotThatDrivesBuildsTheMap() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, FIRST_CORRIDOR));

        assertThat(fixture.runPipe("map"))
                .last()
                .asString()
                .matches("map: [0-9.]+ by [0-9.]+ m, cells of 50 mm, 0 places; .* builds it: \\d+ scans, 0 loops");
        assertThat(fixture.runPipe("map stop")).last().asString().startsWith("map stop: ");
        assertThat(map().grid().stateAt(8000, 0)).isEqualTo(State.FREE);
        assertThat(isWall(8000, -1000)).isTrue();
        assertThat(map().grid().stateAt(8000, 8000)).isEqualTo(State.UNKNOWN);
    }

    @Test
    void theMapGrowsWhileTheRobotDrives() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, FIRST_CORRIDOR / 2));
        int before = map().grid().width();
        drive(way.subList(FIRST_CORRIDOR / 2, FIRST_CORRIDOR));

        assertThat(before).isPositive();
        assertThat(map().grid().count(State.FREE)).isPositive();
        assertThat(fixture.session.map().mappedBy()).contains(robot);
    }

    @Test
    void theFrameOfTheMapIsThatOfTheRobotsPoses() throws InterruptedException {
        robot.place(new Pose(5000, 2000, 90));
        fixture.runPipe("map start 1");
        drive(way.subList(0, FIRST_CORRIDOR));
        fixture.runPipe("map stop");

        assertThat(map().grid().stateAt(5000, 10_000)).isEqualTo(State.FREE);
        assertThat(isWall(6000, 10_000)).isTrue();
    }

    @Test
    void theRobotIsPlacedWhereTheMapHasItWhenItsOdometryIsWrong() throws InterruptedException {
        List<Pose> odometry = floor.odometry(way, 0.02, 0.3);
        fixture.runPipe("map start 1");
        drive(odometry);
        fixture.runPipe("map stop");

        Pose last = way.get(way.size() - 1);
        assertThat(odometry.get(odometry.size() - 1).distanceMm(last)).isGreaterThan(1000);
        assertThat(robot.state().pose().distanceMm(last)).isLessThan(250);
    }

    @Test
    void sonarsDrawTheMapWhereTheOdometryHasTheRobot() throws InterruptedException {
        RangeSensor ring = new RangeSensor(
                "sonar",
                Stream.of(-90, -45, 0, 45, 90)
                        .map(angle -> new Beam(new Pose(0, 0, angle), 30, 0, 5000, 30))
                        .toList());
        robot.place(new Pose(5000, 2000, 90));
        fixture.runPipe("map start 1");
        for (int step = 0; step < FIRST_CORRIDOR; step++) {
            robot.measure(floor.scan(ring, step, way.get(step), way.get(step)));
            fixture.pause(0.1);
        }
        Pose before = robot.odometryOrigin();
        fixture.runPipe("map stop");

        assertThat(robot.odometryOrigin()).isEqualTo(before).isEqualTo(new Pose(5000, 2000, 90));
        assertThat(map().grid().stateAt(5000, 10_000)).isEqualTo(State.FREE);
        assertThat(map().grid().stateAt(8000, 10_000)).isNotEqualTo(State.FREE);
    }

    @Test
    void aRobotThatIsPlacedOnTheMapIsKeptRightThoughItsOdometryIsWrong() throws InterruptedException {
        FakeBot other = onTheMap();
        List<Pose> odometry = floor.odometry(way, 0.02, 0.3);
        fixture.runPipe("2 set pose 0 0 0");
        drive(other, way, odometry);

        Pose last = way.get(way.size() - 1);
        assertThat(odometry.get(odometry.size() - 1).distanceMm(last)).isGreaterThan(1000);
        assertThat(other.state().pose().distanceMm(last)).isLessThan(250);
        assertThat(other.uncertainty().sigmaMm()).isLessThan(200);
        assertThat(fixture.runPipe("2 get placed")).last().asString().matches("2 placed = [0-9.]+ mm, [0-9.]+ deg");
    }

    @Test
    void aRobotIsNoLongerCorrectedOnAMapThatWasClosed() throws InterruptedException {
        FakeBot other = onTheMap();
        fixture.runPipe("2 set pose 0 0 0");
        drive(other, way.subList(0, 20), way.subList(0, 20));
        fixture.runPipe("map close");
        Pose origin = other.odometryOrigin();
        drive(other, way.subList(40, 60), way.subList(20, 40));

        assertThat(other.odometryOrigin()).isEqualTo(origin);
        assertThat(other.uncertainty().isKnown()).isTrue();
    }

    @Test
    void aRobotThatWasCarriedAwayIsFoundAgain() throws InterruptedException {
        FakeBot other = onTheMap();
        fixture.runPipe("2 set pose 0 0 0");
        drive(other, way.subList(0, 60), way.subList(0, 60));
        List<Pose> elsewhere = way.subList(155, 300);
        drive(
                other,
                elsewhere,
                elsewhere.stream()
                        .map(pose -> way.get(60).plus(pose.seenFrom(elsewhere.get(0))))
                        .toList());

        assertThat(fixture.answers())
                .anyMatch(line -> line.contains("does not know where it is on the map"))
                .anyMatch(line -> line.contains("has found its place"));
        assertThat(other.state().pose().distanceMm(elsewhere.get(144))).isLessThan(500);
    }

    @Test
    void aRobotWhoseMeasurementsContradictTheMapNoLongerClaimsToKnowItsPlace() throws InterruptedException {
        FakeBot other = onTheMap();
        fixture.runPipe("2 set pose 8m 0 45");
        drive(other, way.subList(0, 20), way.subList(0, 20));

        assertThat(fixture.answers()).anyMatch(line -> line.contains("does not know where it is on the map"));
        assertThat(fixture.runPipe("2 get placed")).last().asString().contains("unknown (not placed)");
    }

    @Test
    void aRobotThatLooksForItsPlaceFindsTheRightOne() throws InterruptedException {
        FakeBot other = onTheMap();
        assertThat(fixture.runPipe("2 localize")).last().asString().startsWith("2 localize: looks for its place");
        drive(other, way, way);

        assertThat(fixture.answers()).anyMatch(line -> line.contains("has found its place"));
        assertThat(other.state().pose().distanceMm(way.get(way.size() - 1))).isLessThan(500);
    }

    @Test
    void aRobotIsLookedForOnlyOnAMapAndWithRanges() throws InterruptedException {
        assertThat(fixture.runPipe("1 localize")).last().asString().contains("localize: there is no map");
        fixture.add(fixture.aibo);
        assertThat(fixture.runPipe("2 localize")).last().asString().contains("no range sensors");
    }

    @Test
    void aRobotWithoutRangesBuildsNoMap() throws InterruptedException {
        MajicBot other = fixture.add(fixture.aibo);

        assertThat(fixture.runPipe("map start 2"))
                .last()
                .asString()
                .contains("map start: ", "has no range sensors; a robot with a laser scanner or sonars would be right");
        assertThat(other.placedAt()).isEmpty();
    }

    @Test
    void mappingEndsWithTheConnectionOfTheRobotAndTheMapStays() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, FIRST_CORRIDOR));
        robot.cut();
        fixture.pause(1);

        assertThat(fixture.session.map().mappedBy()).isEmpty();
        assertThat(map().grid().stateAt(8000, 0)).isEqualTo(State.FREE);
    }

    @Test
    void aSavedMapIsOpenedWithItsPlaces() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, FIRST_CORRIDOR));
        Path file = folder.resolve("office");

        assertThat(fixture.runPipe(
                        "map stop",
                        "map place desk 1500 300 90",
                        "map place door 2.5m 0",
                        "map save \"" + file + "\"",
                        "map close",
                        "map",
                        "map open \"" + file + ".yaml\""))
                .contains("map place desk: x 1500 mm, y 300 mm", "map: there is no map")
                .last()
                .asString()
                .endsWith("2 places");
        NavigationMap.Place desk = map().places().get(0);
        assertThat(desk.name()).isEqualTo("desk");
        assertThat(desk.pose().distanceMm(new Pose(1500, 300, 0))).isLessThan(0.1);
        assertThat(desk.pose().headingDeg()).isCloseTo(90, within(0.001));
        assertThat(map().places().get(1)).isEqualTo(new NavigationMap.Place("door", new Pose(2500, 0, 0), false));
        assertThat(isWall(8000, -1000)).isTrue();
    }

    @Test
    void aFurtherRobotThatIsPlacedBuildsTheSameMap() throws InterruptedException {
        FakeBot other = fixture.add(fixture.pioneer);
        other.equip(Floor.LASER);
        fixture.runPipe("map start 1");
        drive(way.subList(0, 50));
        assertThat(fixture.runPipe("map start 2")).last().asString().contains("the place of", "is not known");

        Pose corner = way.get(130);
        fixture.runPipe(
                "2 set pose " + corner.xMm() + " " + corner.yMm() + " " + corner.headingDeg(), "2 wait", "map start 2");
        drive(
                other,
                way.subList(130, 180),
                way.subList(130, 180).stream()
                        .map(pose -> pose.seenFrom(corner))
                        .toList());
        assertThat(fixture.runPipe("map")).last().asString().contains(" and ", " build it: ");
        fixture.runPipe("map stop");

        assertThat(map().grid().stateAt(4000, 0)).isEqualTo(State.FREE);
        assertThat(map().grid().stateAt(22_000, 6000)).isEqualTo(State.FREE);
        assertThat(isWall(23_000, 6000)).isTrue();
        assertThat(map().grid().stateAt(11_000, 8000)).isEqualTo(State.UNKNOWN);
    }

    @Test
    void aSavedTeamHasTheMapThatIsInAFile() throws InterruptedException {
        Path file = folder.resolve("office.yaml");
        fixture.runPipe("map start 1");
        drive(way.subList(0, 20));
        fixture.runPipe("map stop");
        assertThat(fixture.session.teamScript()).doesNotContain("map open");
        fixture.runPipe("map save \"" + file + '"');

        String team = fixture.session.teamScript();
        assertThat(team).contains("map open " + file);
        try (ScriptFixture again = new ScriptFixture()) {
            SavedTeam.parse(team).open(again.session);
            again.pause(1);
            assertThat(again.session.map().file()).contains(file);
        }
    }

    @Test
    void otherProgramsGetTheCellsInRows() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, 20));
        fixture.runPipe("map stop");
        OccupancyGrid grid = map().grid();

        List<String> lines = fixture.runPipe("map rows");
        List<String> rows = lines.subList(lines.size() - grid.height(), lines.size());
        assertThat(lines.get(lines.size() - grid.height() - 1))
                .startsWith("map rows: " + grid.height() + " rows of " + grid.width()
                        + " cells of 50 mm, the top row first; ");
        assertThat(rows).allMatch(row -> row.length() == grid.width());
        int column = (int) ((1000 - grid.origin().xMm()) / 50);
        int row = (int) ((0 - grid.origin().yMm()) / 50);
        assertThat(rows.get(grid.height() - 1 - row).charAt(column)).isEqualTo('.');
        assertThat(String.join("", rows)).contains("#", "?");
    }

    @Test
    void aPlaceIsRenamedAndRemoved() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, 5));
        fixture.runPipe("map stop", "map place desk 1500 300 90");

        assertThat(fixture.runPipe("map place Desk as table")).contains("map place Desk as table: done");
        assertThat(map().place("table").orElseThrow().pose()).isEqualTo(new Pose(1500, 300, 90));
        assertThat(map().place("desk")).isEmpty();
        assertThat(fixture.runPipe("map place desk off"))
                .last()
                .asString()
                .contains("desk: there is no such place on the map; there are table");
        assertThat(fixture.runPipe("map place table off")).contains("map place table off: done");
        assertThat(map().places()).isEmpty();
    }

    @Test
    void aMapThatIsNotSavedIsNotReplaced() throws InterruptedException {
        fixture.runPipe("map start 1");
        drive(way.subList(0, 5));

        assertThat(fixture.runPipe("map stop", "map start 1"))
                .last()
                .asString()
                .contains("the map is not saved; \"map save FILE\" keeps it, \"map close\" drops it");
    }

    @Test
    void endingWithoutARobotThatMapsStopsNoRobot() throws InterruptedException {
        assertThat(fixture.runPipe("map stop")).containsExactly("map stop: no robot builds a map");
        assertThat(fixture.team.isLatched()).isFalse();
    }

    @Test
    void whatIsMissingIsNamed() throws InterruptedException {
        assertThat(fixture.refusal("map start")).isPresent();
        assertThat(fixture.refusal("map begin 1"))
                .hasValueSatisfying(text -> assertThat(text)
                        .contains("\"start\", \"stop\", \"open\", \"save\", \"close\", \"rows\" or \"place\""));
        assertThat(fixture.refusal("map stop 1")).isPresent();
        fixture.runPipe("release");
        assertThat(fixture.runPipe("map place desk 0 0")).last().asString().contains("there is no map");
        assertThat(fixture.runPipe("map open missing.yaml")).last().asString().contains("missing.yaml");
    }
}

package majic.nav.mapping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.Pose;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import org.junit.jupiter.api.Test;

/** Mapping of a ring of corridors, 76 m around, with odometry that is wrong by several metres at its end. */
class MapperTest {
    private static final List<Pose> WAY = Floor.around(2).subList(0, 560);

    private static Mapper mapped(List<Pose> way, double share, double degPerM) {
        Floor floor = Floor.ring(1);
        List<Pose> odometry = floor.odometry(way, share, degPerM);
        Mapper mapper = new Mapper();
        for (int index = 0; index < way.size(); index++) {
            mapper.add(floor.scan(Floor.LASER, index, way.get(index), odometry.get(index)));
        }
        return mapper;
    }

    @Test
    void aRingIsClosedAlthoughTheOdometryIsWrongByMetres() {
        Mapper mapper = mapped(WAY, 0.03, 0.5);
        mapper.finish();

        assertThat(mapper.loops()).isGreaterThanOrEqualTo(10);
        for (int index = 0; index < mapper.scans(); index++) {
            Pose truth = WAY.get((int) mapper.scan(index).timeS());
            assertThat(mapper.pose(index).distanceMm(truth)).isLessThan(100);
            assertThat(Pose.normalised(mapper.pose(index).headingDeg() - truth.headingDeg()))
                    .isCloseTo(0, within(0.5));
        }
    }

    @Test
    void wallsAreDrawnWhereTheyAreAndTheFloorIsFree() {
        Mapper mapper = mapped(WAY.subList(0, 100), 0.03, 0.5);
        OccupancyGrid grid = mapper.grid();

        assertThat(grid.stateAt(5000, 0)).isEqualTo(State.FREE);
        assertThat(grid.stateAt(5000, 3000)).isEqualTo(State.UNKNOWN);
        assertThat(List.of(grid.stateAt(10_000, 975), grid.stateAt(10_000, 1025), grid.stateAt(10_000, 1075)))
                .contains(State.OCCUPIED);
    }

    @Test
    void scansOfAStationaryRobotAreNotKept() {
        Floor floor = Floor.ring(1);
        Mapper mapper = new Mapper();
        for (int index = 0; index < 50; index++) {
            mapper.add(floor.scan(Floor.LASER, index, Pose.START, Pose.START));
        }

        assertThat(mapper.scans()).isEqualTo(1);
    }

    @Test
    void theOriginPlacesTheOdometryOnTheMap() {
        Mapper mapper = mapped(WAY.subList(0, 60), 0.03, 0.5);
        int last = mapper.scans() - 1;

        Pose pose = mapper.origin().plus(mapper.scan(last).odometry());

        assertThat(pose.distanceMm(mapper.pose(last))).isLessThan(0.001);
    }

    @Test
    void scansWithoutEchoesAreKeptByTheirOdometry() {
        Mapper mapper = new Mapper();
        float[] nothing = new float[Floor.LASER.beams().size()];
        java.util.Arrays.fill(nothing, Float.POSITIVE_INFINITY);
        for (int index = 0; index < 40; index++) {
            mapper.add(new majic.bot.RangeScan(Floor.LASER, index, new Pose(500 * index, 0, 0), nothing));
        }
        mapper.finish();

        assertThat(mapper.pose(39).xMm()).isCloseTo(39 * 500, within(1.0));
        assertThat(mapper.loops()).isZero();
    }

    @Test
    void theTrajectoryMeetsEveryScanAndJoinsThemSmoothly() {
        Floor floor = Floor.ring(1);
        List<Pose> way = WAY.subList(0, 120);
        List<Pose> odometry = floor.odometry(way, 0.05, 1);
        Mapper mapper = new Mapper();
        Trajectory trajectory = new Trajectory(mapper);
        for (int index = 0; index < way.size(); index++) {
            mapper.add(floor.scan(Floor.LASER, index, way.get(index), odometry.get(index)));
            trajectory.add(index, odometry.get(index));
        }

        List<Trajectory.TimedPose> poses = trajectory.poses();

        assertThat(poses).hasSameSizeAs(way);
        for (int index = 0; index < mapper.scans(); index++) {
            Pose at = poses.get((int) mapper.scan(index).timeS()).pose();
            assertThat(mapper.pose(index).seenFrom(at).distanceMm(Pose.START)).isLessThan(0.01);
        }
        for (int index = 0; index < way.size(); index++) {
            assertThat(poses.get(index).pose().distanceMm(way.get(index))).isLessThan(150);
        }
    }
}

package majic.nav.localisation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.OccupancyGrid;
import majic.nav.mapping.Floor;
import org.junit.jupiter.api.Test;

/** Localisation in a ring of corridors whose map is drawn from true places. */
class LocalizerTest {
    private static final double CONE_DEG = 30;
    private static final int RAYS = 9;
    private static final List<Pose> WAY = Floor.around(1);
    private static final OccupancyGrid MAP = map();

    /** Eight sonars ahead and to the sides, as a Pioneer has them. */
    private static final RangeSensor SONARS = new RangeSensor(
            "sonars",
            IntStream.of(90, 50, 30, 10, -10, -30, -50, -90)
                    .mapToObj(angle -> new Beam(new Pose(100, 0, 0).plus(new Pose(0, 0, angle)), 15, 100, 5000, 20))
                    .toList());

    private final Floor floor = Floor.ring(5);
    private final List<Pose> odometry = floor.odometry(WAY, 0.02, 0.3);

    private static OccupancyGrid map() {
        Floor floor = Floor.ring(2);
        GridBuilder grid = new GridBuilder();
        for (Pose pose : WAY) {
            grid.add(floor.scan(Floor.LASER, 0, pose, pose), pose);
        }
        return grid.toGrid();
    }

    private PoseEstimate follow(Localizer localizer, RangeSensor sensor, int from, int to) {
        for (int index = from; index < to; index++) {
            localizer.add(floor.scan(sensor, index, WAY.get(index), odometry.get(index)));
        }
        return localizer.estimate(odometry.get(to - 1));
    }

    @Test
    void aPlacedRobotIsTrackedAlongTheWay() {
        Localizer localizer = new Localizer(MAP, 1);
        localizer.place(WAY.get(0), 100, 5);
        for (int index = 0; index < 300; index += 20) {
            PoseEstimate is = follow(localizer, Floor.LASER, index, index + 20);

            assertThat(is.placed()).isTrue();
            assertThat(is.pose().distanceMm(WAY.get(index + 19))).isLessThan(200);
            assertThat(Pose.normalised(
                            is.pose().headingDeg() - WAY.get(index + 19).headingDeg()))
                    .isCloseTo(0, within(3.0));
        }
    }

    @Test
    void aRobotWithSonarsIsTracked() {
        Localizer localizer = new Localizer(MAP, 1);
        localizer.place(WAY.get(0), 100, 5);

        PoseEstimate is = follow(localizer, SONARS, 0, 200);

        assertThat(is.placed()).isTrue();
        assertThat(is.pose().distanceMm(WAY.get(199))).isLessThan(600);
    }

    @Test
    void theEchoOfAWideBeamMayComeFromAsideOfItsMiddle() {
        Localizer localizer = new Localizer(MAP, 1);
        localizer.place(WAY.get(0), 100, 5);
        double worstMm = 0;
        for (int index = 0; index < 300; index++) {
            localizer.add(nearestInCones(index));
            worstMm = Math.max(
                    worstMm, localizer.estimate(odometry.get(index)).pose().distanceMm(WAY.get(index)));
        }

        assertThat(localizer.estimate(odometry.get(299)).placed()).isTrue();
        assertThat(worstMm).isLessThan(500);
    }

    /** What sonars measure: the nearest echo of each cone. */
    private RangeScan nearestInCones(int index) {
        List<Beam> cones = SONARS.beams().stream()
                .map(beam -> new Beam(beam.mount(), CONE_DEG, 100, 5000, 20))
                .toList();
        List<Beam> rays = cones.stream()
                .flatMap(cone -> IntStream.range(0, RAYS)
                        .mapToObj(ray -> new Beam(
                                cone.mount().plus(new Pose(0, 0, CONE_DEG * (ray / (RAYS - 1.0) - 0.5))),
                                1,
                                100,
                                5000,
                                20)))
                .toList();
        RangeScan all = floor.scan(new RangeSensor("rays", rays), index, WAY.get(index), odometry.get(index));
        float[] nearest = new float[cones.size()];
        for (int cone = 0; cone < nearest.length; cone++) {
            int first = cone * RAYS;
            nearest[cone] = (float) IntStream.range(first, first + RAYS)
                    .mapToDouble(all::rangeMm)
                    .filter(range -> !Double.isNaN(range))
                    .min()
                    .orElse(Double.NaN);
        }
        return new RangeScan(new RangeSensor("cones", cones), all.timeS(), all.odometry(), nearest);
    }

    @Test
    void aRobotThatFindsItselfIsRightAndIsNotPlacedBefore() {
        Localizer localizer = new Localizer(MAP, 3);

        assertThat(localizer.estimate(odometry.get(0)).placed()).isFalse();
        for (int index = 30; index < 330; index++) {
            PoseEstimate is = follow(localizer, Floor.LASER, index, index + 1);
            if (is.placed()) {
                assertThat(is.pose().distanceMm(WAY.get(index))).isLessThan(500);
                return;
            }
        }
        assertThat(localizer.estimate(odometry.get(329)).placed()).isFalse();
    }

    @Test
    void theSameSeedGivesTheSameEstimates() {
        Localizer one = new Localizer(MAP, 9);
        Localizer other = new Localizer(MAP, 9);
        one.place(WAY.get(0), 200, 5);
        other.place(WAY.get(0), 200, 5);
        var scan = floor.scan(Floor.LASER, 0, WAY.get(5), odometry.get(5));
        one.add(scan);
        other.add(scan);

        assertThat(one.estimate(odometry.get(5))).isEqualTo(other.estimate(odometry.get(5)));
    }
}

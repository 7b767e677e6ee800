package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import majic.bot.MajicBot;
import majic.bot.ParameterException;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import majic.bot.Value;
import majic.inlab.LabRig;
import majicsim.LabOptions;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The scans of the lab's Pioneer, which looks along x, at the origin of the room. */
class RangesInLabTest {
    private static final double WALL_AHEAD_MM = 4500;
    private static final double DISC_AHEAD_MM = 166;
    private static final double LASER_AHEAD_MM = 21;

    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final MajicBot bot = rig.add("pioneer");
    private final List<RangeScan> scans = new CopyOnWriteArrayList<>();
    private final ScanListener listener = scans::add;

    @Test
    void sonarsMeasureTheWallAhead() throws InterruptedException {
        bot.addScanListener(listener);
        rig.await(() -> count(3) > 0 && count(4) > 0);

        assertThat(bot.rangeSensors()).extracting(RangeSensor::name).containsExactly("sonar");
        assertThat(scans).allSatisfy(scan -> {
            assertThat(scan.sensor()).isSameAs(bot.rangeSensors().get(0));
            assertThat(scan.rangeMm(3)).matches(RangesInLabTest::isTheWall);
            assertThat(scan.rangeMm(4)).matches(RangesInLabTest::isTheWall);
            assertThat(scan.timeS()).isBetween(0.0, bot.time().nanos() / 1e9);
        });
    }

    private long count(int disc) {
        return scans.stream().filter(scan -> !Float.isNaN(scan.rangeMm(disc))).count();
    }

    private static boolean isTheWall(float mm) {
        return Float.isNaN(mm) || Math.abs(mm - (WALL_AHEAD_MM - DISC_AHEAD_MM)) <= 2;
    }

    @Test
    void theOdometryOfAScanDoesNotJumpWhenTheRobotIsPlaced() throws InterruptedException {
        bot.addScanListener(listener);
        bot.place(new Pose(3000, -2000, 90));
        bot.move(400);

        Pose last = scans.get(scans.size() - 1).odometry();
        assertThat(last.xMm()).isCloseTo(400, within(20.0));
        assertThat(last.yMm()).isCloseTo(0, within(5.0));
        assertThat(bot.state().pose().yMm()).isCloseTo(-1600, within(20.0));
    }

    @Test
    void afterTheLastListenerThereIsNoScanAndNoSonarIsSwitchedOn() throws InterruptedException {
        rig.run("1 set sonarPower off");
        bot.addScanListener(listener);
        rig.run("wait 1s");
        assertThat(scans).isEmpty();

        rig.run("1 set sonarPower on", "wait 1s");
        assertThat(scans).isNotEmpty();
        bot.removeScanListener(listener);
        rig.run("wait 0.3s");
        int before = scans.size();
        rig.run("wait 1s");
        assertThat(scans).hasSize(before);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theLaserMeasuresTheWallAheadFromItsPlace(boolean exact) throws InterruptedException {
        LabOptions options = LabOptions.exactOnFreePorts().withPioneer("p3dx-sh+laser");
        try (LabRig withLaser = LabRig.of(exact ? options : options.withNoise(3))) {
            MajicBot robot = withLaser.add("pioneer");
            RangeSensor laser = robot.rangeSensors().get(1);
            List<RangeScan> laserScans = new CopyOnWriteArrayList<>();
            robot.addScanListener(scan -> {
                if (scan.sensor() == laser) {
                    laserScans.add(scan);
                }
            });
            withLaser.await(() -> laserScans.size() > 10);

            assertThat(laser.name()).isEqualTo("laser");
            assertThat(laser.beams()).hasSize(181);
            double expected = WALL_AHEAD_MM - laser.beams().get(90).mount().xMm();
            assertThat(laserScans)
                    .allSatisfy(scan ->
                            assertThat((double) scan.rangeMm(90)).isCloseTo(expected, within(exact ? 1.0 : 30.0)));
        }
    }

    @Test
    void theLaserIsRead() throws InterruptedException {
        try (LabRig withLaser = LabRig.exactWithPioneer("p3dx-sh+laser")) {
            MajicBot robot = withLaser.add("pioneer");
            withLaser.run("wait 1s");

            List<Value> sectors = ((Value.Many) robot.get("laser")).values();
            assertThat(sectors).hasSize(6);
            assertThat(sectors.get(2).number()).isCloseTo(WALL_AHEAD_MM - LASER_AHEAD_MM, within(2.0));
            assertThatThrownBy(() -> bot.parameter("laser")).isInstanceOf(ParameterException.class);
        }
    }

    /** With the odometry of a report before or after, the wall would be 140 mm off. */
    @Test
    void theScansOfATurningRobotPutTheWallInItsPlace() {
        try (LabRig withLaser = LabRig.exactWithPioneer("p3dx-sh+laser")) {
            MajicBot robot = withLaser.add("pioneer");
            RangeSensor laser = robot.rangeSensors().get(1);
            List<Double> walls = new CopyOnWriteArrayList<>();
            robot.addScanListener(scan -> {
                if (scan.sensor() == laser) {
                    walls.add(wallAheadMm(scan));
                }
            });
            robot.turn(60);
            robot.turn(-120);

            assertThat(walls).hasSizeGreaterThan(30);
            assertThat(walls).allSatisfy(xMm -> assertThat(xMm).isCloseTo(WALL_AHEAD_MM, within(30.0)));
        }
    }

    /** Where the beam that looks about 20 degrees to the right of the room's x axis meets the wall. */
    private static double wallAheadMm(RangeScan scan) {
        List<Pose> beams = scan.sensor().beams().stream()
                .map(beam -> scan.odometry().plus(beam.mount()))
                .toList();
        int beam = IntStream.range(0, beams.size())
                .boxed()
                .min(Comparator.comparingDouble(
                        index -> Math.abs(beams.get(index).headingDeg() + 20)))
                .orElseThrow();
        return beams.get(beam).after(scan.rangeMm(beam), 0).xMm();
    }
}

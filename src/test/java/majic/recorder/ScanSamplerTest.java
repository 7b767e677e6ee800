package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.Beam;
import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.drivertest.TestClock;
import majic.nav.mapping.Floor;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Which scans of a robot are recorded, and when it is asked for them. */
class ScanSamplerTest {
    @AutoClose
    private final TestClock clock = new TestClock();

    private final TimeSource time = clock.time();
    private final Floor floor = Floor.ring(1);
    private FakeBot robot;
    private ScanSampler sampler;

    @BeforeEach
    void connectARobotWithALaser() {
        robot = FakeBot.on(time);
        robot.connect();
        robot.equip(Floor.LASER);
        sampler = new ScanSampler(2, robot);
    }

    private String sample() {
        StringBuilder lines = new StringBuilder();
        sampler.sample(lines, time.nanos() / 1e9);
        return lines.toString();
    }

    /** Lets the robot measure somewhere after a time, and returns what is recorded of it. */
    private String measuredAt(Pose pose, double seconds) throws InterruptedException {
        time.sleep(seconds);
        robot.measure(floor.scan(Floor.LASER, time.nanos() / 1e9, pose, pose));
        time.sleep(0.01);
        return sample();
    }

    private static Pose at(double x) {
        return new Pose(x, 0, 0);
    }

    @Test
    void theScannerIsDescribedOnceInFrontOfItsScans() throws InterruptedException {
        sample();
        assertThat(measuredAt(at(0), 0.3))
                .matches("(?s)\tsensor\t2\tlaser\t0 0 -90 1 0 20000 10 .*\n\tscan\t2\tlaser\t0.300\t0 0 0\t.*\n");
        assertThat(measuredAt(at(150), 0.3)).startsWith("\tscan\t2\tlaser\t0.610\t150 0 0\t");
        sampler.forget();
        assertThat(measuredAt(at(300), 0.3)).startsWith("\tsensor\t2\tlaser\t").contains("\tscan\t2\t");
    }

    @Test
    void aScanFromTheSamePlaceIsLeftOut() throws InterruptedException {
        sample();
        assertThat(measuredAt(at(0), 0.3)).isNotEmpty();
        assertThat(measuredAt(at(60), 0.3)).isEmpty();
        assertThat(measuredAt(new Pose(60, 0, 4), 0.3)).isEmpty();
        assertThat(measuredAt(new Pose(60, 0, 6), 0.3)).isNotEmpty();
        assertThat(measuredAt(at(150), 0.3)).isNotEmpty();
    }

    @Test
    void atMostFiveScansASecondAreRecorded() throws InterruptedException {
        sample();
        int recorded = 0;
        for (int step = 0; step < 40; step++) {
            recorded += measuredAt(at(step * 200), 0.04).isEmpty() ? 0 : 1;
        }
        assertThat(recorded).isBetween(8, 10);
    }

    @Test
    void aScannerWithManyBeamsIsRecordedLessOften() throws InterruptedException {
        RangeSensor fine = RangeSensor.laser(Pose.START, 1000, -90, 0.18, 20_000, 10);
        robot.equip(fine);
        sample();
        int recorded = 0;
        for (int step = 0; step < 20; step++) {
            time.sleep(0.1);
            robot.measure(new RangeScan(fine, time.nanos() / 1e9, at(step * 200), new float[1000]));
            time.sleep(0.01);
            recorded += sample().isEmpty() ? 0 : 1;
        }
        assertThat(recorded).isBetween(4, 5);
    }

    @Test
    void aStationaryRobotIsNoLongerAskedUntilItMoves() throws InterruptedException {
        sample();
        assertThat(robot.isAskedForScans()).isTrue();
        time.sleep(6);
        sample();
        assertThat(robot.isAskedForScans()).isFalse();
        measuredAt(at(50), 0.1);
        assertThat(robot.isAskedForScans()).isTrue();
    }

    @Test
    void aScanFromBeforeTheLossOfTheConnectionIsLeftOut() throws InterruptedException {
        sample();
        robot.measure(floor.scan(Floor.LASER, time.nanos() / 1e9, at(0), at(0)));
        robot.cut();
        time.sleep(0.01);
        assertThat(sample()).isEmpty();
        assertThat(robot.isAskedForScans()).isFalse();
    }

    @Test
    void aRobotWithoutALaserIsNotAsked() {
        robot.equip(new RangeSensor("sonar", List.of(new Beam(Pose.START, 30, 0, 5000, 30))));
        sample();
        assertThat(robot.isAskedForScans()).isFalse();
    }

    @Test
    void aRobotIsNotAskedAfterTheEnd() {
        sample();
        sampler.end();
        sample();
        assertThat(robot.isAskedForScans()).isFalse();
    }
}

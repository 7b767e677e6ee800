package majic.ros.readings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.driver.RobotWait;
import majic.drivertest.TestClock;
import majic.ros.bridge.TopicSubscription;
import majic.ros.message.CompressedPicture;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The range sensors of a robot and their scans, by the messages of their topics. */
class ScanTopicTest {
    private static final Map<String, String> ONE_LASER =
            Map.of("/scan", "sensor_msgs/LaserScan", "/tf_static", "tf2_msgs/TFMessage");

    private static final Map<String, String> TWO_LASERS = Map.of(
            "/front/scan", "sensor_msgs/LaserScan",
            "/scan", "sensor_msgs/LaserScan");

    private static final Map<String, String> SONAR =
            Map.of("/sonar/left", "sensor_msgs/Range", "/tf_static", "tf2_msgs/TFMessage");

    private static final String SCAN =
            "{'header':{'frame_id':'laser'},'angle_min':-0.5,'angle_increment':0.5,'range_min':0.1,'range_max':5,"
                    + "'ranges':[1.5,Infinity,NaN]}";

    private static final String ECHO =
            "{'header':{'frame_id':'sonar'},'field_of_view':0.5,'min_range':0.02,'max_range':4,'range':0.5}";

    @AutoClose
    private final TestClock clock = new TestClock();

    private final List<RangeScan> scans = new ArrayList<>();
    private final List<String> notices = new ArrayList<>();
    private FakeRosClient robot = new FakeRosClient(false, ONE_LASER);

    private RosReadings begun() {
        RosReadings readings = new RosReadings(
                robot,
                RosSensors.of(robot.topics(), ""),
                new RobotWait(clock.time(), clock.time().signal()),
                new RosReadings.Events() {
                    @Override
                    public void news() {}

                    @Override
                    public void picture(CompressedPicture picture) {}

                    @Override
                    public void scanned(RangeSensor sensor, long measuredNanos, float... rangesMm) {
                        scans.add(new RangeScan(sensor, measuredNanos / 1e9, Pose.START, rangesMm));
                    }

                    @Override
                    public void notice(String message) {
                        notices.add(message);
                    }
                });
        readings.begin();
        return readings;
    }

    private void mounts(String frame, String translation, String rotation) {
        robot.robotPublishes(
                "/tf_static",
                "{'transforms':[{'header':{'frame_id':'base_link'},'child_frame_id':'%s','transform':{'translation':%s,'rotation':%s}}]}"
                        .formatted(frame, translation, rotation));
    }

    private static List<Float> ranges(RangeScan scan) {
        List<Float> ranges = new ArrayList<>();
        for (int beam = 0; beam < scan.size(); beam++) {
            ranges.add(scan.rangeMm(beam));
        }
        return ranges;
    }

    @Test
    void theBeamsOfAScannerAreWhereItIsMounted() {
        RosReadings readings = begun();
        assertThat(readings.rangeSensors()).isEmpty();
        mounts("laser", "{'x':-0.2,'y':0.05,'z':0.1}", "{'x':0,'y':0,'z':1,'w':1}");
        robot.robotPublishes("/scan", SCAN);

        RangeSensor laser = readings.rangeSensors().get(0);

        assertThat(laser.name()).isEqualTo("laser");
        assertThat(laser.beams()).hasSize(3);
        Beam first = laser.beams().get(0);
        assertThat(first.mount().xMm()).isCloseTo(-200, within(1e-9));
        assertThat(first.mount().yMm()).isCloseTo(50, within(1e-9));
        assertThat(first.mount().headingDeg()).isCloseTo(90 - Math.toDegrees(0.5), within(1e-9));
        assertThat(laser.beams().get(2).mount().headingDeg()).isCloseTo(90 + Math.toDegrees(0.5), within(1e-9));
        assertThat(first.leastMm()).isEqualTo(100);
        assertThat(first.reachMm()).isEqualTo(5000);
    }

    @Test
    void aScannerThatIsUpsideDownTurnsTheOtherWay() {
        RosReadings readings = begun();
        mounts("laser", "{'x':0,'y':0,'z':0}", "{'x':1,'y':0,'z':0,'w':0}");
        robot.robotPublishes("/scan", SCAN);

        assertThat(readings.rangeSensors().get(0).beams().get(0).mount().headingDeg())
                .isCloseTo(Math.toDegrees(0.5), within(1e-9));
    }

    @Test
    void aScannerWhosePlaceIsNotReportedIsInTheCentreOfTheRobot() {
        RosReadings readings = begun();
        robot.robotPublishes("/scan", SCAN);

        assertThat(readings.rangeSensors().get(0).beams().get(1).mount()).isEqualTo(new Pose(0, 0, 0));
    }

    @Test
    void ofSeveralScannersEachHasTheNameOfItsTopicAndIsReadOnceUntilSomethingAsks() {
        robot = new FakeRosClient(false, TWO_LASERS);
        RosReadings readings = begun();
        assertThat(robot.subscribed()).contains("/front/scan");

        robot.robotPublishes("/scan", SCAN);
        robot.robotPublishes("/front/scan", SCAN);

        assertThat(readings.rangeSensors()).extracting(RangeSensor::name).containsExactly("scan", "front/scan");
        assertThat(robot.subscribed()).containsExactly("/scan");
        assertThat(scans).isEmpty();
    }

    @Test
    void whileSomethingAsksEachMessageIsAScanInMillimetres() {
        RosReadings readings = begun();
        robot.robotPublishes("/scan", SCAN);
        readings.requestScans(true);
        readings.requestScans(true);
        robot.robotPublishes("/scan", SCAN);
        robot.robotPublishes("/scan", SCAN.replace("[1.5,Infinity,NaN]", "[5,6,0.05]"));
        robot.robotPublishes("/scan", SCAN.replace("[1.5,Infinity,NaN]", "[null,-Infinity,0]"));
        readings.requestScans(false);
        robot.robotPublishes("/scan", SCAN);

        assertThat(scans)
                .extracting(ScanTopicTest::ranges)
                .containsExactly(
                        List.of(1500f, Float.POSITIVE_INFINITY, Float.NaN),
                        List.of(Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.NaN),
                        List.of(Float.NaN, Float.NaN, Float.NaN));
        assertThat(scans.get(0).sensor()).isEqualTo(readings.rangeSensors().get(0));
    }

    @Test
    void allMessagesAreRequestedWhileSomethingAsks() {
        RosReadings readings = begun();
        robot.robotPublishes("/scan", SCAN);
        List<TopicSubscription> before = List.copyOf(robot.wishes);

        readings.requestScans(true);

        List<TopicSubscription> asked = robot.wishes.subList(before.size(), robot.wishes.size());
        assertThat(asked).containsExactly(new TopicSubscription("/scan", "sensor_msgs/LaserScan", 0));
    }

    @Test
    void aScannerThatIsOnlyReadForScansIsUnsubscribedFromWhenNothingAsks() {
        robot = new FakeRosClient(false, TWO_LASERS);
        RosReadings readings = begun();
        robot.robotPublishes("/front/scan", SCAN);
        readings.requestScans(true);
        assertThat(robot.subscribed()).containsExactly("/front/scan", "/scan");

        readings.requestScans(false);

        assertThat(robot.subscribed()).containsExactly("/scan");
    }

    @Test
    void aScanThatIsAskedForBeforeTheFirstMessageNeedsNoDescriptionBefore() {
        RosReadings readings = begun();
        readings.requestScans(true);
        robot.robotPublishes("/scan", SCAN);
        robot.robotPublishes("/scan", SCAN);

        assertThat(scans).hasSize(2);
    }

    @Test
    void aScanWithAnotherNumberOfBeamsIsOfAnotherSensor() {
        RosReadings readings = begun();
        readings.requestScans(true);
        robot.robotPublishes("/scan", SCAN);
        robot.robotPublishes("/scan", SCAN);
        robot.robotPublishes("/scan", SCAN.replace("[1.5,", "[1.5,2,"));

        assertThat(scans.get(1).sensor()).isSameAs(scans.get(0).sensor());
        assertThat(scans.get(2).size()).isEqualTo(4);
        assertThat(readings.rangeSensors()).containsExactly(scans.get(2).sensor());
    }

    @Test
    void aScanIsOfTheTimeOfItsStamp() {
        RosReadings readings = begun();
        readings.requestScans(true);
        publishStamped(1000);
        double firstS = clock.time().nanos() / 1e9;
        pass(0.3);
        publishStamped(1000.1);

        assertThat(scans.get(0).timeS()).isCloseTo(firstS - 0.01, within(1e-6));
        assertThat(scans.get(1).timeS() - scans.get(0).timeS()).isCloseTo(0.1, within(0.01));
    }

    private void publishStamped(double seconds) {
        long nanos = Math.round(seconds % 1 * 1e9);
        robot.robotPublishes(
                "/scan",
                SCAN.replace(
                        "'frame_id'", "'stamp':{'secs':%d,'nsecs':%d},'frame_id'".formatted((long) seconds, nanos)));
    }

    private void pass(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aSingleBeamHasItsConeAndIsWhereItsFrameIs() {
        robot = new FakeRosClient(false, SONAR);
        RosReadings readings = begun();
        readings.requestScans(true);
        robot.robotPublishes("/sonar/left", ECHO);
        assertThat(readings.rangeSensors()).isEmpty();

        mounts("sonar", "{'x':0,'y':0.1,'z':0}", "{'x':0,'y':0,'z':1,'w':1}");
        robot.robotPublishes("/sonar/left", ECHO);

        RangeSensor sonar = readings.rangeSensors().get(0);
        assertThat(sonar.name()).isEqualTo("sonar/left");
        assertThat(sonar.beams().get(0).openingDeg()).isCloseTo(Math.toDegrees(0.5), within(1e-9));
        assertThat(sonar.beams().get(0).mount().headingDeg()).isCloseTo(90, within(1e-9));
        assertThat(scans).hasSize(1);
        assertThat(scans.get(0).rangeMm(0)).isEqualTo(500);
    }

    @ParameterizedTest
    @CsvSource({"'{x: 0, y: 1, z: 0, w: 1}', straight down", "'{x: 0, y: 0.2, z: 0, w: 1}', 23 degrees down"})
    void aSensorThatLooksAtTheFloorIsNone(String rotation, String how) {
        robot = new FakeRosClient(false, SONAR);
        RosReadings readings = begun();
        mounts("sonar", "{'x':0.1,'y':0,'z':0}", rotation.replaceAll("(\\w):", "'$1':"));
        robot.robotPublishes("/sonar/left", ECHO);

        assertThat(readings.rangeSensors()).as(how).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {"[]; 5", "[1]; 0.1"})
    void aScannerWithoutBeamsOrReachIsNone(String ranges, double reach) {
        RosReadings readings = begun();
        readings.requestScans(true);
        robot.robotPublishes(
                "/scan", SCAN.replace("[1.5,Infinity,NaN]", ranges).replace("'range_max':5", "'range_max':" + reach));

        assertThat(readings.rangeSensors()).isEmpty();
        assertThat(scans).isEmpty();
    }

    @Test
    void aSecondScannerWhoseMessagesAreUnusableIsNamedOnce() {
        robot = new FakeRosClient(false, TWO_LASERS);
        RosReadings readings = begun();
        readings.requestScans(true);
        robot.robotPublishes("/front/scan", "{'ranges':null}");
        robot.robotPublishes("/front/scan", "{'ranges':null}");

        assertThat(notices)
                .containsExactly("messages of the topic /front/scan are ignored: ranges has to be a list, not null");
    }
}

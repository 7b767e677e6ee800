package majic.ros.readings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.drivertest.TestClock;
import majic.ros.bridge.TopicSubscription;
import majic.ros.message.BatteryMessage;
import majic.ros.message.BatteryMessage.Supply;
import majic.ros.message.CompressedPicture;
import majic.ros.message.ImuMessage;
import majic.time.Signal;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RosReadingsTest {
    private static final Map<String, String> BURGER = Map.of(
            "/scan", "sensor_msgs/LaserScan",
            "/battery_state", "sensor_msgs/BatteryState",
            "/imu", "sensor_msgs/Imu",
            "/sensor_state", "turtlebot3_msgs/SensorState",
            "/tf_static", "tf2_msgs/TFMessage",
            "/camera/image/compressed", "sensor_msgs/CompressedImage",
            "/odom", "nav_msgs/Odometry");

    private static final String WALL =
            "{'header':{'frame_id':'laser'},'angle_min':-0.5,'angle_increment':0.1,'range_min':0.1,'range_max':3,"
                    + "'ranges':[null,null,1,1,1,1,1,1,1,null,null]}";

    @AutoClose
    private final TestClock clock = new TestClock();

    private final Signal changes = clock.time().signal();
    private final List<String> notices = new ArrayList<>();
    private final AtomicInteger news = new AtomicInteger();
    private final AtomicInteger pictures = new AtomicInteger();
    private FakeRosClient robot = new FakeRosClient(false, BURGER);

    private RosReadings begun() {
        RosReadings readings = new RosReadings(
                robot,
                RosSensors.of(robot.topics(), ""),
                new RobotWait(clock.time(), changes),
                new RosReadings.Events() {
                    @Override
                    public void news() {
                        news.incrementAndGet();
                    }

                    @Override
                    public void picture(CompressedPicture picture) {
                        pictures.incrementAndGet();
                    }

                    @Override
                    public void scanned(RangeSensor sensor, long measuredNanos, float... rangesMm) {
                        throw new AssertionError("nothing asks for scans");
                    }

                    @Override
                    public void notice(String message) {
                        notices.add(message);
                    }
                });
        readings.begin();
        return readings;
    }

    private void pass(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void onlyWhatGuardsAndMapsNeedIsSubscribedToFromTheStart() {
        begun();

        assertThat(robot.subscribed()).containsExactly("/battery_state", "/scan", "/sensor_state", "/tf_static");
    }

    @Test
    void aScanGivesDistancesFromItsArrivalUntilItIsOld() {
        RosReadings readings = begun();
        assertThat(readings.distance(HullSide.FRONT, 100, NoEcho.UNKNOWN)).isEqualTo(Value.unknown("no reading yet"));

        robot.robotPublishes("/scan", WALL);

        assertThat(news).hasValue(1);
        assertThat(readings.distance(HullSide.FRONT, 100, NoEcho.UNKNOWN).number())
                .isBetween(850.0, 900.0);
        pass(1.1);
        assertThat(readings.distance(HullSide.FRONT, 100, NoEcho.UNKNOWN))
                .isEqualTo(Value.unknown("no reading of late"));
    }

    @Test
    void theStampsOfTheRobotDoNotMatter() {
        RosReadings readings = begun();
        for (String stamp : List.of("{'secs':2000000000,'nsecs':0}", "{'secs':0,'nsecs':0}", "{'secs':-5}")) {
            robot.robotPublishes("/scan", WALL.replace("'frame_id'", "'stamp':" + stamp + ",'frame_id'"));
            assertThat(readings.distance(HullSide.FRONT, 100, NoEcho.UNKNOWN)).isInstanceOf(Value.Number.class);
        }
    }

    @Test
    void theFixedFramesPlaceTheScannerOnTheRobot() {
        RosReadings readings = begun();
        robot.robotPublishes(
                "/tf_static",
                "{'transforms':[{'header':{'frame_id':'base_link'},'child_frame_id':'laser','transform':"
                        + "{'translation':{'x':-0.2,'y':0,'z':0.1},'rotation':{'x':0,'y':0,'z':0,'w':1}}}]}");
        robot.robotPublishes("/scan", WALL);

        assertThat(readings.scan().get().orElseThrow().xMm(5)).isEqualTo(800);
    }

    @Test
    void anUnusableMessageIsIgnoredWithOneNotice() {
        RosReadings readings = begun();
        robot.robotPublishes("/scan", WALL);
        robot.robotPublishes("/scan", "{'ranges':null}");
        robot.robotPublishes("/scan", "{'ranges':null}");

        assertThat(notices)
                .containsExactly("messages of the topic /scan are ignored: ranges has to be a list, not null");
        assertThat(readings.scan().get()).isPresent();
    }

    @Test
    void contactsOfATurtleBotAreBumps() {
        RosReadings readings = begun();
        robot.robotPublishes("/sensor_state", "{'bumper':1}");
        assertThat(readings.hazards().isBumped()).isTrue();
        assertThat(readings.hazards().last().orElseThrow().words()).isEqualTo("bump front");

        robot.robotPublishes("/sensor_state", "{'bumper':0}");

        assertThat(readings.hazards().isBumped()).isFalse();
        assertThat(readings.hazards().last()).isPresent();
    }

    @Test
    void anEventOfAKobukiLastsUntilTheOppositeEvent() {
        robot = new FakeRosClient(false, Map.of("/mobile_base/events/bumper", "kobuki_msgs/BumperEvent"));
        RosReadings readings = begun();
        robot.robotPublishes("/mobile_base/events/bumper", "{'state':1,'bumper':0}");
        pass(60);
        assertThat(readings.hazards().isBumped()).isTrue();
        assertThat(readings.hazards().last().orElseThrow().atNanos())
                .isEqualTo(clock.time().nanos());

        robot.robotPublishes("/mobile_base/events/bumper", "{'state':0,'bumper':0}");

        assertThat(readings.hazards().isBumped()).isFalse();
        assertThat(readings.hazards().last().orElseThrow().atNanos())
                .isLessThan(clock.time().nanos());
    }

    @Test
    void theHazardsOfACreate3AreUnknownWhenTheyAreNoLongerRepeated() {
        robot = new FakeRosClient(true, Map.of("/hazard_detection", "irobot_create_msgs/msg/HazardDetectionVector"));
        RosReadings readings = begun();
        assertThat(readings.hasContacts()).isFalse();

        robot.robotPublishes("/hazard_detection", "{'detections':[{'type':2,'header':{'frame_id':'cliff_left'}}]}");

        assertThat(readings.hasContacts()).isTrue();
        assertThat(readings.hazards().isBumped()).isFalse();
        assertThat(readings.hazards().now().get(0).words()).isEqualTo("cliff left");
        pass(6);
        assertThat(readings.hasContacts()).isFalse();
    }

    @Test
    void aReadingOnRequestIsSubscribedToWhileSomethingReadsIt() {
        RosReadings readings = begun();
        RequestedReading<ImuMessage> imu = readings.imu().orElseThrow();
        CompletableFuture<Boolean> read = clock.aside(() -> imu.read().isPresent());
        clock.until(() -> robot.subscribed().contains("/imu"));
        robot.robotPublishes("/imu", "{'orientation':{'x':0,'y':0,'z':0,'w':1}}");
        clock.until(read::isDone);
        assertThat(read.join()).isTrue();

        pass(5);
        imu.read();
        pass(6);
        readings.endUnused();
        assertThat(robot.subscribed()).contains("/imu");
        pass(6);
        readings.endUnused();

        assertThat(robot.subscribed()).doesNotContain("/imu");
    }

    @Test
    void aRecordingAloneSubscribesToNothing() {
        RosReadings readings = begun();

        WaitPolicy.observing(() -> readings.imu().orElseThrow().read());

        assertThat(robot.subscribed()).doesNotContain("/imu");
    }

    @Test
    void aThreadThatMayNotWaitGetsWhatThereIs() {
        RosReadings readings = begun();
        long before = clock.time().nanos();

        WaitPolicy.without(() -> {
            assertThat(readings.imu().orElseThrow().read()).isEmpty();
        });

        assertThat(clock.time().nanos()).isEqualTo(before);
        assertThat(robot.subscribed()).contains("/imu");
    }

    @Test
    void aTopicWithoutMessagesIsAwaitedOnceAndNotAtEachRead() {
        RosReadings readings = begun();
        readings.imu().orElseThrow().read();
        long before = clock.time().nanos();
        readings.imu().orElseThrow().read();

        assertThat(clock.time().nanos()).isEqualTo(before);
        assertThat(readings.imu().orElseThrow().unknown()).isEqualTo(Value.unknown("no reading yet"));
    }

    @Test
    void picturesArePassedOnWhileTheCameraIsRead() {
        RosReadings readings = begun();
        robot.robotPublishes("/camera/image/compressed", "{'format':'jpeg','data':'/9j/'}");
        assertThat(pictures).hasValue(0);

        WaitPolicy.without(() -> {
            readings.camera().orElseThrow().read();
        });
        robot.robotPublishes("/camera/image/compressed", "{'format':'jpeg','data':'/9j/'}");

        assertThat(pictures).hasValue(1);
        pass(2.5);
        readings.endUnused();
        assertThat(robot.subscribed()).doesNotContain("/camera/image/compressed");
    }

    @Test
    void aSonarWithAPlaceOnTheRobotMeasuresItsSide() {
        robot = new FakeRosClient(
                true, Map.of("/sonar_back", "sensor_msgs/msg/Range", "/tf_static", "tf2_msgs/msg/TFMessage"));
        RosReadings readings = begun();
        robot.robotPublishes(
                "/tf_static",
                "{'transforms':[{'header':{'frame_id':'base_link'},'child_frame_id':'sonar','transform':"
                        + "{'translation':{'x':-0.1,'y':0,'z':0},'rotation':{'x':0,'y':0,'z':1,'w':0}}}]}");
        robot.robotPublishes(
                "/sonar_back", "{'header':{'frame_id':'sonar'},'min_range':0.02,'max_range':4,'range':0.5}");

        assertThat(readings.distance(HullSide.BACK, 150, NoEcho.UNKNOWN)).isEqualTo(Value.of(450, Unit.MM));
        assertThat(readings.distance(HullSide.FRONT, 150, NoEcho.UNKNOWN))
                .isEqualTo(Value.unknown("no sensor looks there"));
    }

    @ParameterizedTest
    @CsvSource({
        "/image/compressed /camera/rgb/image_raw/compressed, /camera/rgb/image_raw/compressed",
        "/camera/depth/image_raw/compressed /camera/color/image_raw/compressed, /camera/color/image_raw/compressed",
        "/camera/infra1/image_raw/compressed /camera/stereo/left/image_raw/compressed, /camera/stereo/left/image_raw/compressed",
        "/d/image/compressedDepth /ir/image/compressed, /ir/image/compressed",
        "/fir/image/compressed /front/image/compressed, /fir/image/compressed",
        "/b/image/compressed /a/image/compressed, /a/image/compressed"
    })
    void theCameraWithColoursIsShown(String names, String shown) {
        Map<String, String> topics = Arrays.stream(names.split(" "))
                .collect(Collectors.toMap(name -> name, name -> "sensor_msgs/msg/CompressedImage"));

        assertThat(RosSensors.of(topics, "").camera().orElseThrow().name()).isEqualTo(shown);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/rear/image/compressed", "rear/image/compressed", "/rear/image"})
    void anotherCameraIsChosenByItsName(String name) {
        RosSensors sensors = RosSensors.of(
                Map.of(
                        "/rgb/image/compressed", "sensor_msgs/CompressedImage",
                        "/rear/image/compressed", "sensor_msgs/CompressedImage"),
                "");

        RosSensors chosen = sensors.withCamera(name).orElseThrow();

        assertThat(chosen.camera().orElseThrow().name()).isEqualTo("/rear/image/compressed");
        assertThat(chosen.cameras()).containsExactlyInAnyOrderElementsOf(sensors.cameras());
        assertThat(sensors.withCamera("/front/image")).isEmpty();
    }

    @Test
    void theCoreSensorsOfAKobukiAreItsContactsAndItsBattery() {
        robot = new FakeRosClient(true, Map.of("/sensors/core", "kobuki_ros_interfaces/msg/SensorState"));
        RosReadings readings = begun();
        robot.robotPublishes(
                "/sensors/core", "{'bumper':4,'wheel_drop':0,'cliff':1,'charger':0,'battery':163,'over_current':0}");

        assertThat(readings.hazards().now())
                .extracting(ActiveHazards.Report::words)
                .containsExactly("bump left", "cliff right");
        assertThat(readings.battery().get().orElseThrow().volts().getAsDouble()).isCloseTo(16.3, within(1e-9));
    }

    @Test
    void theFirstBatteryInASpotCounts() {
        robot = new FakeRosClient(false, Map.of("/status/battery_states", "spot_msgs/BatteryStateArray"));
        RosReadings readings = begun();
        robot.robotPublishes(
                "/status/battery_states",
                "{'battery_states':[{'status':1},{'status':2,'charge_percentage':0.8,'voltage':56.5}]}");

        assertThat(readings.battery().get())
                .contains(new BatteryMessage(OptionalDouble.of(56.5), OptionalDouble.of(0.8), Supply.CHARGING));
    }

    @ParameterizedTest
    @CsvSource({"'', /scan", "/robot1, /robot1/scan", "/robot2, /robot2/front/scan", "/robot3, /scan"})
    void aRobotHasTheSensorsOfItsNamespace(String namespace, String scan) {
        RosSensors sensors = RosSensors.of(
                Map.of(
                        "/scan", "sensor_msgs/msg/LaserScan",
                        "/robot1/scan", "sensor_msgs/msg/LaserScan",
                        "/robot1/filters/scan", "sensor_msgs/msg/LaserScan",
                        "/robot2/front/scan", "sensor_msgs/msg/LaserScan",
                        "/robot2/points", "sensor_msgs/msg/PointCloud2"),
                namespace);

        assertThat(sensors.scan().orElseThrow().name()).isEqualTo(scan);
    }

    @Test
    void theLossOfTheConnectionForSensorsMakesTheirReadingsNone() {
        RosReadings readings = begun();
        robot.robotPublishes("/scan", WALL);
        robot.robotPublishes("/battery_state", "{'percentage':0.5,'voltage':12}");
        assertThat(readings.scan().get()).isPresent();

        robot.losesSideConnections();

        assertThat(readings.scan().get()).isEmpty();
        assertThat(readings.scan().unknown()).isEqualTo(Value.unknown("no reading of late"));
        assertThat(readings.battery().get()).isEmpty();
    }

    @Test
    void onlyWhatEndsAMotionIsReadOnTheConnectionThatDrivesTheRobot() {
        begun();

        assertThat(robot.subscribed()).contains("/sensor_state");
        assertThat(robot.wishes)
                .extracting(TopicSubscription::topic)
                .contains("/scan")
                .doesNotContain("/sensor_state");
        assertThat(robot.wishes)
                .allMatch(wish -> wish.queueLength() == 1 || wish.topic().equals("/tf_static"));
    }
}

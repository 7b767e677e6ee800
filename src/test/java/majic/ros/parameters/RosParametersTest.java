package majic.ros.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import majic.ros.bridge.Arriving;
import majic.ros.bridge.TopicSubscription;
import majic.ros.readings.FakeRosClient;
import majic.ros.readings.RosSensors;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RosParametersTest {
    private static final Map<String, String> TOPICS = Map.of(
            "/scan", "sensor_msgs/LaserScan",
            "/battery_state", "sensor_msgs/BatteryState",
            "/imu", "sensor_msgs/Imu",
            "/joint_states", "sensor_msgs/JointState",
            "/sensor_state", "turtlebot3_msgs/SensorState",
            "/sonar/left", "sensor_msgs/Range",
            "/camera/image/compressed", "sensor_msgs/CompressedImage",
            "/gas", "std_msgs/Float32",
            "/odom", "nav_msgs/Odometry");

    private static final Map<String, String> LARGE_TOPICS = Map.of(
            "/camera/image_raw", "sensor_msgs/Image",
            "/map", "nav_msgs/OccupancyGrid",
            "/odom", "nav_msgs/Odometry");

    @AutoClose
    private final FakeRosRobot robot = new FakeRosRobot(new FakeRosClient(false, TOPICS));

    /** Publishes, while the driver waits for the first message of a topic that it has just subscribed to. */
    private Value get(String parameter, String topic, String message) {
        WaitPolicy.without(() -> {
            robot.bot().get(parameter);
        });
        robot.client().robotPublishes(topic, message);
        return robot.bot().get(parameter);
    }

    @Test
    void aRobotHasTheParametersOfItsSensorsAndNoOthers() {
        assertThat(robot.bot().parameters())
                .extracting(Parameter::name)
                .contains(
                        "distanceFront",
                        "scan",
                        "rangeLeft",
                        "bumped",
                        "battery",
                        "voltage",
                        "gyro",
                        "joints",
                        "camera")
                .doesNotContain("goalLeft");

        robot.sensors(Map.of("/odom", "nav_msgs/Odometry"));

        assertThat(robot.bot().parameters())
                .extracting(Parameter::name)
                .contains("pose", "speed")
                .doesNotContain("distanceFront", "battery", "bumped", "gyro", "camera");
    }

    @Test
    void sharedParametersHaveTheirUsualNamesAndUnits() {
        robot.client().robotPublishes("/battery_state", "{'voltage':11.1,'percentage':0.5,'power_supply_status':1}");
        robot.client().robotPublishes("/sensor_state", "{'bumper':2}");
        robot.client().robotPublishes("/sonar/left", "{'range':0.25,'min_range':0.02,'max_range':4}");

        assertThat(robot.bot().get("battery")).isEqualTo(Value.of(50, Unit.PERCENT));
        assertThat(robot.bot().get("voltage")).isEqualTo(Value.of(11.1, Unit.V));
        assertThat(robot.bot().get("charging")).isEqualTo(Value.text("charging"));
        assertThat(robot.bot().get("bumped")).isEqualTo(Value.yesNo(true));
        assertThat(robot.bot().get("hazards")).isEqualTo(Value.text("bump back"));
        assertThat(robot.bot().get("rangeLeft")).isEqualTo(Value.of(250, Unit.MM));
    }

    @Test
    void noEchoIsUnknownUntilTheUserSetsThatItIsClear() {
        String dark = "{'angle_min':-0.6,'angle_increment':0.1,'range_min':0.1,'range_max':3,"
                + "'ranges':[null,null,null,null,null,null,null,null,null,null,null,null,null]}";
        robot.client().robotPublishes("/scan", dark);
        assertThat(robot.bot().get("distanceFront")).isInstanceOf(Value.Unknown.class);

        robot.bot().set("noEcho", "clear");

        assertThat(robot.bot().get("distanceFront")).isEqualTo(Value.CLEAR);
        assertThat(robot.bot().get("scanBeams")).isEqualTo(Value.of(13, Unit.NONE));
        assertThat(robot.bot().get("scanEchoes")).isEqualTo(Value.of(0, Unit.NONE));
        assertThat(robot.bot().get("scanNearest")).isEqualTo(Value.unknown("no echo"));
    }

    @Test
    void motionSensorsAreInDegrees() {
        assertThat(get("gyro", "/imu", "{'angular_velocity':{'x':0,'y':0,'z':1.5707963267948966}}"))
                .isEqualTo(Value.of(90, Unit.DEG_PER_S));
        assertThat(robot.bot().get("roll")).isEqualTo(Value.unknown("the inertial unit does not measure it"));
        assertThat(get("joints", "/joint_states", "{'name':['a','b'],'position':[3.141592653589793]}"))
                .isEqualTo(Value.many(List.of(Value.of(180, Unit.DEG), Value.unknown("not reported"))));
        assertThat(robot.bot().get("jointNames")).isEqualTo(Value.text("a, b"));
    }

    @Test
    void jointsThatSlideAreInMillimetres() {
        robot.sensors(RosSensors.of(robot.client().topics(), "").withSlidingJoints(Set.of("lift")));

        assertThat(get("joints", "/joint_states", "{'name':['lift','a'],'position':[0.25,0],'velocity':[-0.1,0]}"))
                .isEqualTo(Value.many(List.of(Value.of(250, Unit.MM), Value.of(0, Unit.DEG))));
        assertThat(robot.bot().get("jointRates"))
                .isEqualTo(Value.many(List.of(Value.of(-100, Unit.MM_PER_S), Value.of(0, Unit.DEG_PER_S))));
    }

    @Test
    void aLargeNumberIsNotShownWithWrongDigits() {
        CompletableFuture<String> shown = robot.aside(() -> robot.run("topic", "odom/id"));
        robot.clock().until(() -> robot.client().subscribed().contains("/odom"));
        robot.client().robotPublishes("/odom", "{'id':9007199254740993,'small':9007199254740991}");

        assertThat(robot.clock().join(shown)).isEqualTo("9007199254740993");
        assertThat(robot.bot().get("topic/odom/id")).hasToString("about 9007199254740992");
        assertThat(robot.bot().get("topic/odom/small")).hasToString("9007199254740991");
    }

    @Test
    void theCameraTellsWhatItsNewestPictureIs() {
        assertThat(get("camera", "/camera/image/compressed", "{'format':'jpeg','data':'AAEC'}"))
                .isEqualTo(Value.text("jpeg, 0.003 kB"));
        assertThat(robot.bot().get("cameraAge")).isEqualTo(Value.of(0, Unit.MS));
    }

    @ParameterizedTest
    @CsvSource({
        "topic/odom/pose/pose/position/x, 1.5",
        "topic/ODOM/Pose/pose/Position/x, 1.5",
        "topic/odom/list/1, 8",
        "topic/odom/flag, yes",
        "topic/odom/child_frame_id, base_link",
        "topic/odom/none, unknown (none is not finite)",
        "topic/odom/pose/pose/position/q, 'unknown (position has no q; it has x, y)'",
        "topic/odom/pose/pose/positio/x, unknown (pose has no positio; did you mean position?)",
        "topic/odom/list, unknown (write a field behind list; it has the numbers 0 to 2)",
        "topic/odom/list/3, unknown (list has no 3; it has the numbers 0 to 2)",
        "topic/odom/list/x, unknown (list has no x; it has the numbers 0 to 2)"
    })
    void everyFieldOfEveryTopicCanBeRead(String parameter, String expected) {
        String message = "{'child_frame_id':'base_link','pose':{'pose':{'position':{'x':1.5,'y':0}}},"
                + "'list':[7,8,9],'flag':true,'none':null}";

        assertThat(get(parameter, "/odom", message)).hasToString(expected);
        assertThat(robot.client().subscribed()).contains("/odom");
    }

    @Test
    void aTopicWithASingleFieldNeedsNoName() {
        assertThat(get("topic/gas", "/gas", "{'data':0.25}")).isEqualTo(Value.of(0.25, Unit.NONE));
        assertThat(robot.bot().parameters()).extracting(Parameter::name).contains("topic/gas");
    }

    @ParameterizedTest
    @CsvSource({
        "topic/odm/x, odm/x: the robot has no such topic; did you mean odom?",
        "topic/xy/z, xy/z: the robot has no such topic; the command \"topics\" lists them",
        "topic/odon, odon: the robot has no such topic; did you mean odom?",
        "topic/sonar/right, sonar/right: the robot has no such topic; near ones are sonar/left",
        "topic/image, image: the robot has no such topic; near ones are camera/image/compressed"
    })
    void anUnknownTopicIsRefusedWithNearOnes(String parameter, String message) {
        assertThatThrownBy(() -> robot.bot().get(parameter))
                .isInstanceOf(ParameterException.class)
                .hasMessage(message);
    }

    @Test
    void otherUnknownParametersAreRefusedAsUsual() {
        assertThatThrownBy(() -> robot.bot().get("volage"))
                .isInstanceOf(ParameterException.class)
                .hasMessageContaining("has no such parameter; did you mean voltage?");
    }

    @Test
    void topicsAreListedWithTheirTypes() {
        assertThat(robot.run("topics", "sonar")).isEqualTo("/sonar/left (sensor_msgs/Range)");
        assertThat(robot.run("topics", "lidar")).isEqualTo("none of 9 topics");
        assertThat(robot.run("topics")).contains("/gas (std_msgs/Float32), /imu");
    }

    @Test
    void oneMessageOfATopicIsShownWithItsFields() {
        WaitPolicy.without(() -> {
            assertThatThrownBy(() -> robot.run("topic", "odom")).hasMessage("/odom: no reading yet");
        });
        robot.client()
                .robotPublishes(
                        "/odom", "{'header':{'frame_id':'odom'},'c':[0,0,0,0,0,0,0,0],'v':[1,2],'t':[{'a':1}]}");

        assertThat(robot.run("topic", "odom")).isEqualTo("header/frame_id: odom, c: 8 values, v: [1,2], t/0/a: 1");
        assertThat(robot.run("topic", "/odom/v/1")).isEqualTo("2");
    }

    @Test
    void aServiceIsCalledWithTypedArguments() {
        robot.client().robotOffers("/reset", arguments -> FakeRosClient.json("{}"));
        robot.client().robotOffers("/spawn", arguments -> FakeRosClient.json("{'name':'t2'}"));

        assertThat(robot.run("call", "reset")).isEqualTo("done, without an answer");
        assertThat(robot.run("call", "/spawn", "x=1 pose.y=2.5", "name=bob flag=true list=[1,2]"))
                .isEqualTo("name: t2");
        assertThat(robot.client().sent)
                .contains(
                        "call /reset {}",
                        "call /spawn {\"x\":1,\"pose\":{\"y\":2.5},\"name\":\"bob\",\"flag\":true,\"list\":[1,2]}");
    }

    @Test
    void aServiceMayBeCalledWithJson() {
        robot.client().robotOffers("/spawn", arguments -> FakeRosClient.json("{'success':true,'message':'there'}"));

        assertThat(robot.run("call", "spawn", "{x: 1, name: 'bob b'}")).isEqualTo("success: true, message: there");
        assertThat(robot.client().sent).contains("call /spawn {\"x\":1,\"name\":\"bob b\"}");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{x: | is not JSON",
                "{x: 1} y | is not JSON",
                "{x: NaN} | is not JSON",
                "x 1 | x 1: is no argument; write them as in \"x=1 name=bob\" or \"{x: 1}\"",
                "x=1 =2 | =2: is no argument"
            })
    void wrongArgumentsAreRefusedBeforeTheServiceIsCalled(String arguments, String message) {
        robot.client().robotOffers("/spawn", given -> FakeRosClient.json("{}"));

        assertThatThrownBy(() -> robot.run("call", "spawn", arguments)).hasMessageContaining(message);
        assertThat(robot.client().sent).noneMatch(sent -> sent.startsWith("call /spawn"));
    }

    @Test
    void aServiceThatDoesNotExistIsRefusedWithNearOnes() {
        robot.client()
                .robotOffers(
                        "/rosapi/services",
                        given -> FakeRosClient.json("{'services':['/reset','/robot/reset_odometry']}"));

        assertThatThrownBy(() -> robot.run("call", "reste"))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("reste: the robot has no such service; did you mean /reset?");
    }

    @Test
    void aServiceThatReportsAFailureFails() {
        robot.client().robotOffers("/arm", given -> FakeRosClient.json("{'success':false,'message':'no power'}"));

        assertThatThrownBy(() -> robot.run("call", "arm")).hasMessageContaining("the service failed: no power");
    }

    @Test
    void aStopEndsTheWaitForAService() {
        robot.client().robotOffers("/slow", FakeRosClient.NEVER);
        CompletableFuture<String> call = robot.aside(() -> robot.run("call", "slow"));
        robot.clock().until(() -> robot.client().sent.contains("call /slow {}"));
        long before = robot.clock().time().nanos();

        robot.bot().stop();
        robot.clock().until(call::isDone);

        assertThatThrownBy(call::join).cause().isInstanceOf(MotionStopped.class);
        assertThat(robot.clock().time().secondsSince(before)).isLessThan(0.1);
        assertThat(robot.client().sent).contains("close call");
    }

    @Test
    void aServiceThatNeverAnswersFailsAfterTenSeconds() {
        robot.client().robotOffers("/slow", FakeRosClient.NEVER);

        assertThatThrownBy(() -> robot.run("call", "slow"))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("/slow did not answer within 10 s");
    }

    @Test
    void aTopicWithLargeMessagesIsReadOneMessageAtATimeInTheSmallestForm() {
        try (FakeRosRobot large = new FakeRosRobot(new FakeRosClient(false, LARGE_TOPICS))) {
            FakeRosClient client = large.client();
            client.messageBytes = 2_764_800;
            for (int read = 1; read <= 2; read++) {
                CompletableFuture<String> width = large.aside(
                        () -> large.bot().get("topic/camera/image_raw/width").toString());
                large.clock().until(() -> client.subscribed().contains("/camera/image_raw"));
                client.robotPublishes("/camera/image_raw", "{'width':1280,'height':720}");

                assertThat(large.clock().join(width)).isEqualTo("1280");
                assertThat(client.subscribed()).doesNotContain("/camera/image_raw");
                assertThat(client.wishes)
                        .hasSize(read)
                        .allMatch(wish -> wish.binary() && wish.queueLength() == 1 && wish.throttleMs() > 10_000);
                pass(large, 1);
            }
        }
    }

    @Test
    void aTopicWithSmallMessagesIsStreamedFromTheSecondReadOn() {
        robot.client().messageBytes = 300;
        get("topic/gas/data", "/gas", "{'data':2.5}");

        assertThat(robot.bot().get("topic/gas/data")).hasToString("2.5");

        assertThat(robot.client().wishes)
                .filteredOn(wish -> wish.topic().equals("/gas"))
                .extracting(TopicSubscription::throttleMs)
                .containsExactly(60_000, 100);
        assertThat(robot.client().subscribed()).contains("/gas");
    }

    @Test
    void odometryIsNeverAskedForInAFormInWhichServersDoNotSendIt() {
        get("topic/odom/pose/pose/position/x", "/odom", "{'pose':{'pose':{'position':{'x':1}}}}");

        assertThat(robot.client().wishes)
                .filteredOn(wish -> wish.topic().equals("/odom"))
                .noneMatch(TopicSubscription::binary);
    }

    @Test
    void aTopicThatIsLargeOrSlowIsSaidToBe() {
        try (FakeRosRobot large = new FakeRosRobot(new FakeRosClient(false, LARGE_TOPICS))) {
            large.client().arriving = new Arriving(1_200_000, 16_000_000, false);
            CompletableFuture<String> map = large.aside(() -> large.run("topic", "map"));
            assertThatThrownBy(() -> large.clock().join(map))
                    .hasMessageContaining(
                            "the topic /map is large or the connection slow: 1.2 of 16.0 MB have arrived");

            large.client().arriving = new Arriving(0, 0, true);
            assertThat(large.bot().get("topic/map/info/width"))
                    .hasToString("unknown (the topic /map is large: messages of more than 16 MB are left out)");
        }
    }

    @Test
    void aMessageThatIsArrivingIsAwaited() {
        try (FakeRosRobot large = new FakeRosRobot(new FakeRosClient(false, LARGE_TOPICS))) {
            large.client().arriving = new Arriving(1_200_000, 16_000_000, false);
            CompletableFuture<String> map = large.aside(() -> large.run("topic", "map/info/width"));
            pass(large, 8);
            large.client().messageBytes = 16_000_000;
            large.client().robotPublishes("/map", "{'info':{'width':4000}}");

            assertThat(large.clock().join(map)).isEqualTo("4000");
        }
    }

    private static void pass(FakeRosRobot robot, double seconds) {
        long from = robot.clock().time().nanos();
        robot.clock().until(() -> robot.clock().time().secondsSince(from) >= seconds);
    }
}

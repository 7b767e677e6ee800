package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.anyLong;
import static org.mockito.Mockito.doAnswer;
import static org.mockito.Mockito.mock;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.driver.RobotWait;
import majic.drivertest.ScriptedPeer;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.link.Links;
import majic.link.Loopback;
import majic.ros.graph.KnownRobots;
import majic.time.LastWait;
import majic.time.TimeSource;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Connecting to a server, and why it fails. */
class RosConnectingTest {
    private static void assertFails(ThrowingCallable connect, Reason reason, String... parts) {
        assertThatThrownBy(connect)
                .isInstanceOfSatisfying(
                        ConnectFailed.class,
                        failed -> assertThat(failed.reason()).isEqualTo(reason))
                .hasMessageContainingAll(parts);
    }

    private static MajicRos facing(ScriptedPeer peer) {
        return new MajicRos(
                new BotAddress("ros", "//" + peer.address()),
                new BotEnvironment(peer.clock().time(), Settings.inMemory()));
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    @Test
    void connectingNamesTheModelAndTheTopics() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.bot().connect();

            assertThat(robot.bot().introduction())
                    .isEqualTo("a ROS robot (TurtleBot3 fake Burger, ROS 1 noetic, drives by /cmd_vel with /odom)");
            assertThat(robot.bot().get("model")).hasToString("TurtleBot3 fake Burger");
            assertThat(robot.bot().get("timeout")).hasToString("stops after 1.0 s");
            assertThat(robot.bot().profile().bodyMm()).isEqualTo(105);
        }
    }

    @Test
    void connectingPublishesNothing() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.bot().connect();

            assertThat(robot.received)
                    .noneMatch(operation -> operation.path("op").asText().equals("publish"));
            assertThat(robot.bot().state()).isNotEqualTo(BotState.UNKNOWN);
        }
    }

    @Test
    void connectingGoesOnWhenTheFirstOdometryHasBeenTakenIn() {
        try (ScriptedRos robot = new ScriptedRos()) {
            TimeSource time = robot.peer.clock().time();
            LastWait last = new LastWait(time.signal());
            List<Boolean> wentOn = new CopyOnWriteArrayList<>();
            RosSession.Events events = mock();
            doAnswer(reading -> wentOn.add(last.isOver())).when(events).odometry(any(), any(), anyLong());
            RosSession session = new RosSession(
                    RosAddress.parse(new BotAddress("ros", "//" + robot.peer.address())),
                    new RobotWait(time, last),
                    events);

            session.find(KnownRobots.builtIn());
            session.awaitOdometry();
            session.abort();

            assertThat(wentOn).startsWith(false);
        }
    }

    @Test
    void aPortWithoutAServerIsRefused() {
        int port = Loopback.freePort();
        try (MajicRos bot = new MajicRos("ros://127.0.0.1:" + port)) {
            assertFails(bot::connect, Reason.REFUSED, "nothing listens at 127.0.0.1 port " + port);
        }
    }

    @Test
    void aWebServerIsQuoted() {
        try (ScriptedPeer peer = new ScriptedPeer((from, bytes) ->
                        from.send(ascii("HTTP/1.1 404 Not Found\r\nServer: nginx\r\n\r\n<html>no</html>")));
                MajicRos bot = facing(peer)) {
            assertFails(
                    bot::connect,
                    Reason.WRONG_DEVICE,
                    "is a web server, but no rosbridge server: it answers \"HTTP/1.1 404 Not Found\"",
                    "usually 9090");
        }
    }

    @Test
    void aServerOfAnotherKindIsQuoted() {
        ScriptedPeer.Robot ssh = new ScriptedPeer.Robot() {
            @Override
            public void connected(ScriptedPeer from) {
                from.send(ascii("SSH-2.0-OpenSSH_9.2\r\n"));
            }

            @Override
            public void received(ScriptedPeer from, byte[] bytes) {
                from.hangUp();
            }
        };
        try (ScriptedPeer peer = new ScriptedPeer(ssh);
                MajicRos bot = facing(peer)) {
            assertFails(bot::connect, Reason.WRONG_DEVICE, "it sends \"SSH-2.0-OpenSSH_9.2\"");
        }
    }

    @Test
    void aServerThatClosesAtOnceIsNamed() {
        try (ScriptedPeer peer = new ScriptedPeer((from, bytes) -> from.hangUp());
                MajicRos bot = facing(peer)) {
            assertFails(bot::connect, Reason.WRONG_DEVICE, "closed the connection at once", "ross://" + peer.address());
        }
    }

    @Test
    void aServerThatDoesNotAnswerIsGivenUp() {
        try (ScriptedPeer peer = new ScriptedPeer((from, bytes) -> {});
                MajicRos bot = facing(peer)) {
            assertFails(bot::connect, Reason.NO_ANSWER, "did not answer within 3.0 s");
            assertThat(Links.traffic()).noneMatch(traffic -> traffic.remote().equals(peer.address()));
        }
    }

    @Test
    void aServerThatClosesAtTheFirstRequestMayDemandAuthentication() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.hangsUpAtFirstRequest = true;

            assertFails(
                    robot.bot()::connect, Reason.NOT_ALLOWED, "does it demand authentication?", "authenticate:=false?");
        }
    }

    /** The advice of the type asks whether the server runs, which is answered where it is there. */
    @Test
    void theAdviceAboutTheServerIsOnlyGivenWhereThereIsNone() {
        RosType type = new RosType();
        assertThat(type.adviceAfter("nothing listens at host port 9090")).contains("Is the robot on");
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.topics.remove("/cmd_vel");

            assertThatThrownBy(robot.bot()::connect)
                    .satisfies(failed -> assertThat(type.adviceAfter(String.valueOf(failed.getMessage())))
                            .isEqualTo(failed.getMessage()));
        }
    }

    @Test
    void aServerWithoutRosapiIsExplained() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.services.clear();

            assertFails(
                    robot.bot()::connect,
                    Reason.NO_ANSWER,
                    "its node rosapi is not",
                    "Service /rosapi/topics does not exist");
        }
    }

    @Test
    void questionsThatAServerForbidsDelayTheConnectionByOneTimeLimitTogether() {
        try (ScriptedRos robot = new ScriptedRos()) {
            for (int i = 0; i < 10; i++) {
                robot.topics.put("/nav" + i + "_nav/cmd_vel", "geometry_msgs/Twist");
            }
            robot.wholeAnswer = call -> call.path("service").asText().matches(".*(nodes|subscribers|get_param)")
                    ? "{\"op\":\"status\"}"
                    : "";
            long start = robot.peer.millis();
            robot.bot().connect();

            assertThat(robot.peer.millis() - start).isLessThan(6000);
            assertThat(robot.bot().introduction()).contains("unknown robot", "ROS 1,", "/cmd_vel with /odom");
        }
    }

    @Test
    void aSystemWithoutABaseIsExplained() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.topics.remove("/cmd_vel");

            assertFails(robot.bot()::connect, Reason.WRONG_DEVICE, "no robot that can be driven", "ROS 1 noetic");
        }
    }

    @Test
    void odometryThatDoesNotArriveIsNamed() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.reports = false;

            assertFails(robot.bot()::connect, Reason.NO_ANSWER, "/odom", "nothing arrives within 5.0 s");
        }
    }

    @Test
    void odometryWithoutNumbersIsNamed() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.reports = false;
            robot.peer.clock().aside(() -> {
                robot.peer.clock().until(() -> robot.isSubscribed("/odom"));
                robot.publish("/odom", ScriptedRos.parse("{\"pose\":{\"pose\":{\"position\":{\"x\":null}}}}"));
            });

            assertFails(robot.bot()::connect, Reason.NO_ANSWER, "the odometry /odom cannot be used", "position.x");
        }
    }

    @Test
    void aBaseWithoutOdometryIsDrivenByDeadReckoning() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.topics.remove("/odom");
            robot.bot().connect();

            robot.bot().move(200);

            assertThat(robot.bot().profile().estimates()).isTrue();
            assertThat(robot.bot().state().pose().xMm()).isBetween(180.0, 220.0);
        }
    }

    @Test
    void severalRobotsAreToldApartByTheirNamespaces() {
        try (ScriptedRos robot = new ScriptedRos("/tb3_1")) {
            robot.topics.put("/tb3_1/cmd_vel", "geometry_msgs/Twist");
            robot.topics.put("/tb3_2/cmd_vel", "geometry_msgs/Twist");
            robot.subscribers.put("/tb3_1/cmd_vel", List.of("/node"));
            robot.subscribers.put("/tb3_2/cmd_vel", List.of("/node"));
            robot.bot().connect();

            assertThat(robot.bot().introduction()).contains("drives by /tb3_1/cmd_vel without odometry");
        }
    }

    @Test
    void theRobotOfTheTableMayBeNamedInTheAddress() {
        try (ScriptedRos robot = new ScriptedRos("?robot=epuck2")) {
            robot.bot().connect();

            assertThat(robot.bot().get("model")).hasToString("e-puck2");
            assertThat(robot.bot().get("timeout")).hasToString("drives on");
        }
        try (ScriptedRos robot = new ScriptedRos("?robot=roomba")) {
            assertFails(robot.bot()::connect, Reason.OTHER, "there is no robot roomba in the table", "e-puck2");
        }
    }

    @Test
    void aRobotWithoutANamespaceDoesNotGetTheSensorsOfAnotherOne() {
        try (ScriptedRos robot = new ScriptedRos("?base=/cmd_vel")) {
            robot.topics.put("/tb3_1/cmd_vel", "geometry_msgs/Twist");
            robot.subscribers.put("/tb3_1/cmd_vel", List.of("/node"));
            robot.topics.put("/tb3_1/scan", "sensor_msgs/LaserScan");
            robot.topics.put("/tb3_1/move_base/goal", "move_base_msgs/MoveBaseActionGoal");
            robot.topics.put("/sensors/imu", "sensor_msgs/Imu");
            robot.bot().connect();

            assertThat(robot.bot().parameters())
                    .extracting(Parameter::name)
                    .contains("gyro")
                    .doesNotContain("scan", "goalLeft");
            assertThat(robot.bot().commands()).extracting(BotCommand::name).doesNotContain("goto");
        }
    }

    @Test
    void ofSeveralCamerasOneIsShownAndAllAreNamed() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.topics.put("/front/image/compressed", "sensor_msgs/CompressedImage");
            robot.topics.put("/camera/rgb/image/compressed", "sensor_msgs/CompressedImage");
            List<String> notices = new CopyOnWriteArrayList<>();
            robot.bot().addListener(new BotListener() {
                @Override
                public void notice(MajicBot from, String message) {
                    notices.add(message);
                }
            });
            robot.bot().connect();

            robot.peer
                    .clock()
                    .until(
                            () -> notices.stream()
                                    .anyMatch(
                                            notice -> notice.startsWith(
                                                    "its camera is /camera/rgb/image/compressed;"
                                                            + " there are also /front/image/compressed, one of which is chosen by ?camera=TOPIC")));
        }
    }

    @Test
    void theCameraMayBeNamedInTheAddress() {
        try (ScriptedRos robot = new ScriptedRos("?camera=/rear/image")) {
            assertFails(robot.bot()::connect, Reason.OTHER, "no camera /rear/image", "it has none at all");
        }
        try (ScriptedRos robot = new ScriptedRos("?camera=/rear/image")) {
            robot.topics.put("/front/image/compressed", "sensor_msgs/CompressedImage");
            assertFails(robot.bot()::connect, Reason.OTHER, "no camera /rear/image", "is it /front/image/compressed?");
        }
        try (ScriptedRos robot = new ScriptedRos("?camera=front/image")) {
            robot.topics.put("/front/image/compressed", "sensor_msgs/CompressedImage");
            robot.topics.put("/rgb/compressed", "sensor_msgs/CompressedImage");
            robot.bot().connect();

            assertThat(robot.bot().hasCamera()).isTrue();
        }
    }

    @Test
    void theDescriptionOfTheRobotTellsWhichJointsSlide() {
        try (ScriptedRos robot = new ScriptedRos()) {
            robot.topics.put("/joint_states", "sensor_msgs/JointState");
            robot.parameters.put(
                    "/robot_description", "<robot name=\"r\"><joint name=\"lift\" type=\"prismatic\"/></robot>");
            robot.bot().connect();

            assertThat(robot.bot().session().slidingJoints()).containsExactly("lift");
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "ros:host",
                "ros://",
                "ros://host:0",
                "ros://host:99999",
                "ros://host/a b",
                "ros://host?base=",
                "ros://host?colour=red",
                "ros:tcp://host:9090",
                "ros:///robot1",
                "ros+vendor://host"
            })
    void aWrongAddressIsRefusedWithARightOne(String address) {
        assertThatThrownBy(() -> new RosType().create(BotAddress.parse(address), BotEnvironment.plain()))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith(address + ": ");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "ros://host",
                "ros://192.168.1.20:9090",
                "ros://[fe80::1]:9090/robot1",
                "ROSS://robot.local/a/b/",
                "ros://host?base=/odom&robot=Husky&camera=/front/image_raw&path=/ws"
            })
    void aRightAddressIsAccepted(String address) {
        MajicBot bot = new RosType().create(BotAddress.parse(address), BotEnvironment.plain());
        assertThat(bot.type().name()).isEqualTo("ros");
        bot.close();
    }
}

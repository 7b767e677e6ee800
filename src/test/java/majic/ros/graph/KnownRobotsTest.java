package majic.ros.graph;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The table of known robots. */
class KnownRobotsTest {
    private final Map<String, String> topics = new HashMap<>();
    private final Map<String, String> parameters = new HashMap<>();
    private final TreeSet<String> nodes = new TreeSet<>();

    private KnownRobot recognised(int version, String namespace) {
        RosGraph graph = new RosGraph(version, "", topics, nodes);
        return KnownRobots.builtIn()
                .recognise(new RobotEvidence(graph, namespace, name -> Optional.ofNullable(parameters.get(name))));
    }

    @Test
    void everyEntryHasPossibleNumbersAndANameOfItsOwn() {
        KnownRobots known = KnownRobots.builtIn();

        assertThat(known.names()).hasSizeGreaterThan(15).doesNotHaveDuplicates();
        assertThat(known.names()).allSatisfy(name -> {
            KnownRobot robot = known.named(name).orElseThrow();
            assertThat(robot.radiusMm()).isBetween(30.0, 1000.0);
            assertThat(robot.speedMmPerSec()).isBetween(100.0, 3000.0);
            assertThat(robot.turnDegPerSec()).isBetween(30.0, 360.0);
            assertThat(robot.slowestMmPerSec()).isBetween(1.0, 50.0);
        });
    }

    @Test
    void aTurtleBot3OnRos2KeepsItsLastVelocityAndOneOnRos1DoesNot() {
        nodes.add("/turtlebot3_node");
        topics.put("/sensor_state", "turtlebot3_msgs/msg/SensorState");
        KnownRobot onRos2 = recognised(2, "");
        assertThat(onRos2.timeoutS()).isInfinite();
        assertThat(onRos2.afterCommands()).isEqualTo("drives on");

        nodes.clear();
        topics.put("/sensor_state", "turtlebot3_msgs/SensorState");
        parameters.put("/tb3_model", "burger");
        KnownRobot onRos1 = recognised(1, "");
        assertThat(onRos1.name()).isEqualTo("TurtleBot3 Burger");
        assertThat(onRos1.afterCommands()).isEqualTo("stops after 0.5 s");
    }

    @Test
    void aParameterTellsTheModelsApart() {
        nodes.add("/turtlebot3_node");
        parameters.put("/turtlebot3_node:wheels.separation", "0.287");
        assertThat(recognised(2, "").name()).isEqualTo("TurtleBot3 Waffle (ROS 2)");

        parameters.put("/turtlebot3_node:wheels.separation", "0.16");
        assertThat(recognised(2, "").name()).isEqualTo("TurtleBot3 Burger (ROS 2)");
    }

    @Test
    void topicsCountOnlyInTheNamespaceOfTheRobot() {
        topics.put("/a/hazard_detection", "irobot_create_msgs/msg/HazardDetectionVector");
        topics.put("/b/ps0", "sensor_msgs/msg/Range");
        topics.put("/b/tof", "sensor_msgs/msg/Range");

        assertThat(recognised(2, "/a").name()).isEqualTo("Create 3");
        assertThat(recognised(2, "/b").name()).isEqualTo("e-puck2");
        assertThat(recognised(2, "/c")).isEqualTo(KnownRobots.UNKNOWN);
    }

    @Test
    void theTopicsOfTheEntryArePreferredWhereTheyAreThere() {
        topics.put("/husky_velocity_controller/odom", "nav_msgs/Odometry");
        topics.put("/cmd_vel", "geometry_msgs/Twist");
        RosGraph graph = new RosGraph(1, "", topics, nodes);
        Base found = new Base("", "/other/cmd_vel", Base.TWIST_STAMPED, "/other/odom");

        Base better = KnownRobots.withTopics(recognised(1, ""), found, graph);

        assertThat(better).isEqualTo(new Base("", "/cmd_vel", Base.TWIST, "/husky_velocity_controller/odom"));
    }

    @Test
    void theUsersEntriesComeFirst() {
        nodes.add("/turtlebot3_node");
        KnownRobots known = KnownRobots.builtIn().with("ros-robots.txt", """
                robot Lab Turtle   # ours
                  when node turtlebot3_node
                  like TurtleBot3 Burger
                  radius 140
                  timeout none
                """);
        KnownRobot turtle =
                known.recognise(new RobotEvidence(new RosGraph(2, "", topics, nodes), "", name -> Optional.empty()));

        assertThat(turtle.name()).isEqualTo("Lab Turtle");
        assertThat(turtle.radiusMm()).isEqualTo(140);
        assertThat(turtle.speedMmPerSec()).isEqualTo(220);
        assertThat(turtle.timeoutS()).isInfinite();
        assertThat(known.named("LAB-turtle")).contains(turtle);
    }

    @Test
    void aWrongLineIsRefusedWithItsPlaceAndWhatWouldBeRight() {
        assertRefused("radius 100", "robots line 1: an entry begins with \"robot NAME\"");
        assertRefused("robot A", "radius ten", "robots line 2: a number from 0.001 to 1000000 is missing");
        assertRefused("robot A", "radius -3", "robots line 2: -3 is not a number from 0.001 to 1000000");
        assertRefused("robot A", "speed 1e308", "robots line 2: 1e308 is not a number from 0.001 to 1000000");
        assertRefused("robot A", "robot !!", "robots line 2: behind \"robot\" a name is missing");
        assertRefused("robot A", "note " + "x".repeat(500), "robots line 2: the line is longer than 500 characters");
        assertRefused("robot A", "", "when colour red", "robots line 3: \"colour\" is no test");
        assertRefused("robot A", "when param /x", "robots line 2: \"param\" needs 2 more word(s)");
        assertRefused("robot A", "like B", "robots line 2: there is no robot B above");
        assertRefused("robot A", "wheels 3", "robots line 2: \"wheels\" is no property");
    }

    private static void assertRefused(String... linesAndMessage) {
        int last = linesAndMessage.length - 1;
        String text = String.join("\n", Arrays.copyOf(linesAndMessage, last));
        assertThatThrownBy(() -> KnownRobots.builtIn().with("robots", text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(linesAndMessage[last]);
    }
}

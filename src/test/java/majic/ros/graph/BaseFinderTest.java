package majic.ros.graph;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import majic.bot.ConnectFailed;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** The robots behind a server, found by their topics. */
class BaseFinderTest {
    private final Map<String, String> topics = new HashMap<>();
    private final Map<String, List<String>> subscribers = new HashMap<>();
    private int version = 1;

    private void commands(String... names) {
        for (String name : names) {
            topics.put(name, type("geometry_msgs/Twist"));
            subscribers.put(name, List.of("/base_node"));
        }
    }

    private void odometry(String... names) {
        for (String name : names) {
            topics.put(name, type("nav_msgs/Odometry"));
        }
    }

    private String type(String twoParts) {
        return version == 2 ? twoParts.replace("/", "/msg/") : twoParts;
    }

    private RosGraph graph() {
        return new RosGraph(version, "test", topics, new TreeSet<>());
    }

    private BaseFinder finder() {
        return new BaseFinder(graph(), topic -> Optional.ofNullable(subscribers.get(topic)));
    }

    private Base choose(String namespace, @Nullable String name) {
        return new BaseChoice(graph(), finder(), "ros://host:9090").choose(namespace, name);
    }

    @Test
    void aSingleRobotNeedsNoNamespace() {
        commands("/cmd_vel");
        odometry("/odom");

        assertThat(choose("", null)).isEqualTo(new Base("", "/cmd_vel", Base.TWIST, "/odom"));
    }

    @Test
    void typesOfRos2AreUnderstood() {
        version = 2;
        commands("/cmd_vel");
        odometry("/odom");

        assertThat(choose("", null)).isEqualTo(new Base("", "/cmd_vel", Base.TWIST, "/odom"));
    }

    @Test
    void aHuskyIsOneRobotAlthoughItsControllerHasTopicsOfItsOwn() {
        commands("/cmd_vel", "/husky_velocity_controller/cmd_vel", "/joy_teleop/cmd_vel");
        odometry("/odometry/filtered", "/husky_velocity_controller/odom");

        assertThat(finder().all()).containsExactly(new Base("", "/cmd_vel", Base.TWIST, "/odometry/filtered"));
    }

    @Test
    void aTurtleBot2IsDrivenByTheTopicOfItsBase() {
        commands("/mobile_base/commands/velocity");
        odometry("/odom");

        assertThat(choose("", null).command()).isEqualTo("/mobile_base/commands/velocity");
    }

    @Test
    void aTopicThatNoNodeReceivesIsNoRobot() {
        commands("/cmd_vel", "/old/cmd_vel");
        subscribers.put("/old/cmd_vel", List.of());
        odometry("/odom");

        assertThat(finder().all()).hasSize(1);
    }

    @Test
    void severalRobotsAreListedWithTheirAddresses() {
        commands("/robot1/cmd_vel", "/robot2/cmd_vel");
        odometry("/robot1/odom", "/robot2/odom");

        assertThatThrownBy(() -> choose("", null))
                .isInstanceOf(ConnectFailed.class)
                .hasMessage("there are 2 robots behind ros://host:9090; is it ros://host:9090/robot1 or"
                        + " ros://host:9090/robot2?");
        assertThat(choose("/robot2", null).odometry()).isEqualTo("/robot2/odom");
        assertThat(choose("", "/robot1").command()).isEqualTo("/robot1/cmd_vel");
        assertThat(choose("", "/robot2/odom").command()).isEqualTo("/robot2/cmd_vel");
    }

    @Test
    void anAddressMayNameAnotherOdometry() {
        commands("/cmd_vel");
        odometry("/odometry/filtered", "/wheel/odom", "/odom");

        assertThat(choose("", null).odometry()).isEqualTo("/odometry/filtered");
        assertThat(choose("", "/odom").odometry()).isEqualTo("/odom");
    }

    @Test
    void aNamespaceThatIsNotThereIsAnsweredWithThoseThatAre() {
        commands("/robot1/cmd_vel");
        odometry("/robot1/odom");

        assertThatThrownBy(() -> choose("/robot3", null))
                .hasMessage("there is no robot /robot3 behind ros://host:9090; is it ros://host:9090/robot1?");
    }

    @Test
    void aSystemWithoutARobotIsExplained() {
        topics.put("/chatter", "std_msgs/String");

        assertThatThrownBy(() -> choose("", null))
                .hasMessage(
                        "no robot that can be driven is behind ros://host:9090, which runs ROS 1 test with 1 topics:"
                                + " none of the type geometry_msgs/Twist or TwistStamped is received by a node; do the robot's"
                                + " own nodes (bringup) run?");
    }

    @Test
    void aRobotWithoutOdometryIsFound() {
        commands("/turtle1/cmd_vel");

        assertThat(choose("", null)).isEqualTo(new Base("/turtle1", "/turtle1/cmd_vel", Base.TWIST, null));
    }

    @Test
    void stampedCommandsAreFoundWithTheirType() {
        version = 2;
        topics.put("/cmd_vel", "geometry_msgs/msg/TwistStamped");
        odometry("/odom");

        assertThat(choose("", null).commandType()).isEqualTo(Base.TWIST_STAMPED);
    }
}

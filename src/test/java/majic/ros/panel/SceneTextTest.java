package majic.ros.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import majic.bot.MajicBot.Connection;
import majic.ros.message.Hazard;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneTextTest {
    private static final long SCAN_NANOS = 7;

    private final RosScene scene = Scenes.of(
            ScanEchoes.of(new double[] {1000, Double.NaN, -500}, new double[] {0, Double.NaN, 250}, SCAN_NANOS),
            List.of(new RosScene.Contact(Hazard.WHEEL_DROP, "left_wheel"), new RosScene.Contact(Hazard.BUMP, "")),
            new RosScene.Battery(OptionalDouble.of(11.8), OptionalInt.of(73), false, "not charging"),
            List.of(
                    new RosScene.Topic("/odom", "nav_msgs/msg/Odometry", 0),
                    new RosScene.Topic("/scan", "sensor_msgs/msg/LaserScan", Double.POSITIVE_INFINITY)));

    @Test
    void aRecordedSceneIsTheSame() {
        assertThat(SceneText.parse(SceneText.of(scene), Connection.CONNECTED, SCAN_NANOS))
                .contains(scene);
    }

    @Test
    void anUnknownBatteryIsRecordedToo() {
        RosScene unknown = Scenes.of(null, List.of(), RosScene.Battery.UNKNOWN, List.of());
        assertThat(SceneText.parse(SceneText.of(unknown), Connection.CONNECTED, 0))
                .contains(unknown);
    }

    @Test
    void aLargeScanIsThinned() {
        double[] many = new double[1440];
        Map<String, String> texts =
                SceneText.of(Scenes.of(ScanEchoes.of(many, many, 0), List.of(), scene.battery(), List.of()));
        assertThat(SceneText.scanOf(texts).split(" ")).hasSize(180);
    }

    @Test
    void withoutTheRobotThereIsNoScene() {
        assertThat(SceneText.parse(Map.of(), Connection.CONNECTED, 0)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"robot", "link", "scan", "contacts", "battery", "topics"})
    void aDamagedTextGivesNoScene(String name) {
        Map<String, String> damaged = new HashMap<>(SceneText.of(scene));
        damaged.put(name, "x y z w");
        Optional<RosScene> read = SceneText.parse(damaged, Connection.CONNECTED, 0);
        assertThat(read).isEmpty();
    }
}

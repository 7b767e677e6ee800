package majic.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.FakeType;
import majic.environment.Settings;
import majic.ros.RosType;
import majic.shared.SharedType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests which addresses are those of one robot. */
class SameRobotTest {
    private final BotFactory factory =
            new BotFactory(List.of(new FakeType(), new SharedType(), new RosType()), Settings.inMemory());

    @ParameterizedTest
    @CsvSource({
        "mqtt://broker/lab/desk/1, mqtt://broker:1883/lab/desk/1",
        "mqtts://broker/lab/desk/1, mqtts://broker:8883/lab/desk/1",
        "MQTTS://broker/lab/desk/1, mqtts://BROKER:8883/lab/desk/1",
    })
    void theUsualPortOfTheSchemeMakesNoDifference(String without, String with) {
        assertThat(factory.isSameRobot(without, with)).isTrue();
    }

    @Test
    void theUsualPortOfAnotherSchemeMakesADifference() {
        assertThat(factory.isSameRobot("mqtts://broker/lab/desk/1", "mqtts://broker:1883/lab/desk/1"))
                .isFalse();
    }

    @Test
    void theParameterFileMakesNoDifference() {
        assertThat(factory.isSameRobot("pioneer:/dev/ttyS0?params=a.p", "pioneer:/dev/ttyS0"))
                .isTrue();
        assertThat(factory.isSameRobot("pioneer://10.0.0.5:8101?params=a.p", "pioneer://10.0.0.5:8101?params=b.p"))
                .isTrue();
        assertThat(factory.isSameRobot("ros://10.0.0.5?base=odom", "ros://10.0.0.5"))
                .isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "ros://host/robot1",
                "ros://host:9090/robot1",
                "ROS://HOST/robot1/",
                "ros://host//robot1",
                "ros://host/robot1//"
            })
    void furtherSlashesMakeNoDifference(String address) {
        assertThat(factory.isSameRobot(address, "ros://host/robot1")).isTrue();
    }

    @Test
    void theCaseOfANameBehindAServerMakesADifference() {
        assertThat(factory.isSameRobot("ros://host/Robot1", "ros://host/robot1"))
                .isFalse();
        assertThat(factory.isSameRobot("ros://host/robot1?base=/Odom", "ros://host/robot1?base=/odom"))
                .isFalse();
    }
}

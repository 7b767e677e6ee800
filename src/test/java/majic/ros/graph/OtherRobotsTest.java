package majic.ros.graph;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OtherRobotsTest {
    @ParameterizedTest(name = "beside {0}: {1} belongs to another robot: {2}")
    @CsvSource({
        "'', /scan, false",
        "'', /robot1/scan, true",
        "'', /robot10/scan, false",
        "/robot1, /robot1/scan, false",
        "/robot1, /robot1/arm/scan, true",
        "/robot1, /robot2/scan, true",
        "/robot1, /scan, false",
        "/robot1/arm, /robot1/scan, false",
        "/robot1/arm, /robot1/arm/scan, false"
    })
    void whatIsInTheNamespaceOfAnotherRobotIsItsOwn(String chosen, String topic, boolean another) {
        List<Base> all = Stream.of("", "/robot1", "/robot1/arm", "/robot2")
                .map(OtherRobotsTest::base)
                .toList();

        assertThat(OtherRobots.besides(base(chosen), all).have(topic)).isEqualTo(another);
    }

    private static Base base(String namespace) {
        return new Base(namespace, namespace + "/cmd_vel", Base.TWIST, null);
    }
}

package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests filters of topics by the examples of the MQTT specification, 4.7.1. */
class TopicFilterTest {
    @ParameterizedTest
    @CsvSource({
        "sport/tennis/player1/#, sport/tennis/player1, true",
        "sport/tennis/player1/#, sport/tennis/player1/score/wimbledon, true",
        "sport/tennis/+, sport/tennis/player1, true",
        "sport/tennis/+, sport/tennis/player1/ranking, false",
        "sport/+, sport, false",
        "sport/+, sport/, true",
        "+/+, /finance, true",
        "+, /finance, false",
        "sport, sports, false",
        "sport/tennis, sport, false",
        "sport, sport/tennis, false",
        "sport/+/ranking, sport//ranking, true",
        "sport/+/ranking, sport/tennis/score, false",
        "sport/tennis, sport/tennisball, false",
        "+/uptime, $SYS/uptime, false",
        "#, $SYS/uptime, false",
        "$SYS/#, $SYS/uptime, true"
    })
    void aFilterIsForTheTopicsThatTheSpecificationNames(String filter, String topic, boolean matches) {
        assertThat(new TopicFilter(filter).matches(topic)).isEqualTo(matches);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sport+", "a/#/b", "a#", "a/b+/c"})
    void aWildcardIsALevelOfItsOwn(String filter) {
        assertThatThrownBy(() -> new TopicFilter(filter)).isInstanceOf(IllegalArgumentException.class);
    }
}

package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.BotException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the addresses of brokers. */
class BrokerAddressTest {
    @ParameterizedTest
    @CsvSource({
        "mqtt://broker/lab, false, broker, 1883, lab",
        "mqtt://broker:1884/lab/, false, broker, 1884, lab",
        "MQTTS://10.0.0.5/school/lab, true, 10.0.0.5, 8883, school/lab",
        "mqtt://[::1]:1883/lab/desk2/1, false, [::1], 1883, lab/desk2/1"
    })
    void anAddressHasABrokerAndAPath(String text, boolean secure, String host, int port, String site) {
        assertThat(BrokerAddress.parse(text)).isEqualTo(new BrokerAddress(secure, host, port, site));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "mqtt://broker", "mqtt://broker/", "mqtt://broker:0/lab", "mqtt://broker:99999/lab", "mqtt:/broker/lab",
                "http://broker/lab", "mqtt://broker/lab//a", "mqtt://broker/la+b", "mqtt://broker/#", "broker/lab"
            })
    void aWrongAddressIsRefusedWithARightOne(String text) {
        assertThatThrownBy(() -> BrokerAddress.parse(text))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith(text + ": not the address of a broker")
                .hasMessageContaining("mqtt://192.168.1.20/lab");
    }

    @Test
    void aPasswordInAnAddressIsRefusedAndNotRepeated() {
        assertThatThrownBy(() -> BrokerAddress.parse("mqtt://anna:secret@broker/lab"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("brokers.properties")
                .hasMessageContaining("MAJIC_MQTT_PASSWORD")
                .hasMessageNotContaining("secret");
    }

    @Test
    void anAddressIsWrittenAsItIsTyped() {
        assertThat(BrokerAddress.parse("mqtt://broker:1883/lab/")).hasToString("mqtt://broker/lab");
        assertThat(BrokerAddress.parse("mqtts://broker:1883/lab")).hasToString("mqtts://broker:1883/lab");
    }
}

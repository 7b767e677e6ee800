package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.BotAddress;
import majic.bot.BotException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The addresses of vehicles, as users type them. */
class MavlinkAddressTest {
    private static MavlinkAddress parse(String text) {
        return MavlinkAddress.parse(BotAddress.parse(text));
    }

    @ParameterizedTest
    @CsvSource({
        "mavlink:udp://:14550, udp://:14550",
        "mavlink:udp://, udp://:14550",
        "mavlink:udp://0.0.0.0:14551, udp://:14551",
        "mavlink:udp://[::]:14550, udp://:14550",
        "mavlink:udp://Rover.local:14550, udp://rover.local:14550",
        "mavlink://192.168.1.20, tcp://192.168.1.20:5760",
        "mavlink:tcp://[fe80::1]:5762, tcp://[fe80::1]:5762",
        "mavlink:/dev/ttyUSB0?baud=115200, serial:/dev/ttyUSB0",
    })
    void theSamePlaceHasTheSameKey(String address, String key) {
        assertThat(parse(address).endpoint().key()).isEqualTo(key);
    }

    @Test
    void withoutANumberItIsTheOnlyVehicle() {
        assertThat(parse("mavlink:udp://:14550").system()).isZero();
        assertThat(parse("mavlink:udp://:14550?system=3").system()).isEqualTo(3);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "mavlink:udp://:14550?system=0",
                "mavlink:udp://:14550?system=255",
                "mavlink:udp://:0",
                "mavlink:udp://:70000",
                "mavlink:/dev/ttyUSB0?baud=0",
                "mavlink:udp://:14550?radius=0",
            })
    void aNumberOutOfItsRangeIsNamed(String address) {
        assertThatThrownBy(() -> parse(address))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("is no number from 1 to");
    }

    @ParameterizedTest
    @ValueSource(strings = {"mavlink://", "mavlink://0.0.0.0:5760", "mavlink:udpin://:14550", "mavlink:udp://a:b"})
    void otherAddressesAreRefusedWithExamples(String address) {
        assertThatThrownBy(() -> parse(address))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("it looks like mavlink:udp://:14550");
    }
}

package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;

import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;
import org.junit.jupiter.api.Test;

class LedReadingsTest {
    private final LedReadings leds = new LedReadings();

    @Test
    void eachReadingFindsItsLamp() {
        String order = LedReadings.order("mjx_1", UrbiVersion.V1_0);

        assertThat(order).contains("mjx_1_lamp0: ledF1.val").contains("mjx_1_lamp27: earR.val");
        assertThat(leds.hear(message("mjx_1_lamp0", 0.5))).isTrue();
        assertThat(leds.hear(message("mjx_1_lamp27", 1))).isTrue();
        assertThat(leds.amount("ledF1")).contains(0.5);
        assertThat(leds.amount("earR")).contains(1.0);
        assertThat(leds.amount("ledF2")).isEmpty();
    }

    @Test
    void laterServersAreAskedThroughChannels() {
        assertThat(LedReadings.order("t", UrbiVersion.V1_5)).contains("t_lamp0 << ledF1.val");
    }

    @Test
    void whatIsNoLampsReadingIsLeftToOthers() {
        assertThat(leds.hear(message("notag", 1))).isFalse();
        assertThat(leds.hear(message("my_lamp99", 1))).isFalse();
        assertThat(leds.hear(message("my_lamps", 1))).isFalse();
    }

    @Test
    void anotherDogsLampsAreForgotten() {
        leds.hear(message("t_lamp0", 1));
        leds.clear();

        assertThat(leds.amount("ledF1")).isEmpty();
    }

    private static UrbiMessage message(String tag, double amount) {
        return new UrbiMessage(0, tag, new UrbiMessage.Result(new UrbiValue.Num(amount)));
    }
}

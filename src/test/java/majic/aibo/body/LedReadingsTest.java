package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;

import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;
import org.junit.jupiter.api.Test;

class LedReadingsTest {
    private final LedReadings leds = new LedReadings();

    @Test
    void eachReadingIsStoredForItsLed() {
        String order = LedReadings.order("mjx_1", UrbiVersion.V1_0);

        assertThat(order).contains("mjx_1_led0: ledF1.val").contains("mjx_1_led27: earR.val");
        assertThat(leds.take(message("mjx_1_led0", 0.5))).isTrue();
        assertThat(leds.take(message("mjx_1_led27", 1))).isTrue();
        assertThat(leds.amount("ledF1")).contains(0.5);
        assertThat(leds.amount("earR")).contains(1.0);
        assertThat(leds.amount("ledF2")).isEmpty();
    }

    @Test
    void laterServersAreAskedThroughChannels() {
        assertThat(LedReadings.order("t", UrbiVersion.V1_5)).contains("t_led0 << ledF1.val");
    }

    @Test
    void otherReadingsAreIgnored() {
        assertThat(leds.take(message("notag", 1))).isFalse();
        assertThat(leds.take(message("my_led99", 1))).isFalse();
        assertThat(leds.take(message("my_leds", 1))).isFalse();
    }

    @Test
    void theReadingsOfThePreviousConnectionAreDiscarded() {
        leds.take(message("t_led0", 1));
        leds.clear();

        assertThat(leds.amount("ledF1")).isEmpty();
    }

    private static UrbiMessage message(String tag, double amount) {
        return new UrbiMessage(0, tag, new UrbiMessage.Result(new UrbiValue.Num(amount)));
    }
}

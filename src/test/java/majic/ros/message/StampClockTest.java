package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** When messages were measured, by a robot's clock that does not agree with this computer's. */
class StampClockTest {
    private static final double PERIOD_S = 0.04;

    private final StampClock clock = new StampClock(true);
    private double nowS = 5000;
    private double robotAheadS = 1.7e9;

    private static JsonNode message(double stampS) {
        ObjectNode message = JsonNodeFactory.instance.objectNode();
        message.putObject("header")
                .putObject("stamp")
                .put("secs", (long) Math.floor(stampS))
                .put("nsecs", Math.round((stampS - Math.floor(stampS)) * 1e9));
        return message;
    }

    /** The age of a message that arrives after being under way for a time. */
    private double age(double underWayS, double roundTripS) {
        nowS += PERIOD_S;
        long nanos = Math.round(nowS * 1e9);
        return (nanos - clock.measuredNanos(message(nowS - underWayS + robotAheadS), nanos, roundTripS)) / 1e9;
    }

    private void hear(int count, double underWayS) {
        for (int i = 0; i < count; i++) {
            age(underWayS, 2 * underWayS);
        }
    }

    @ParameterizedTest(name = "{0} s ahead")
    @ValueSource(doubles = {0, 1.7e9, 3600, -3600})
    void messagesThatAreAsFastAsTheFastestAreHalfARoundTripOld(double aheadS) {
        robotAheadS = aheadS + 10_000;
        hear(50, 0.02);

        assertThat(age(0.02, 0.04)).isCloseTo(0.02, within(0.005));
    }

    @Test
    void messagesThatWaitInAQueueGetOlder() {
        hear(50, 0.02);
        for (double underWayS = 0.02; underWayS < 6; underWayS += PERIOD_S / 2) {
            age(underWayS, underWayS);
        }

        assertThat(age(6, 6)).isCloseTo(6, within(0.5));
    }

    @ParameterizedTest(name = "by {0} s")
    @ValueSource(doubles = {3600, -3600, 0.5, -0.5})
    void aClockThatIsSetMakesNoMessageOld(double seconds) {
        hear(50, 0.02);
        robotAheadS += seconds;

        for (int i = 0; i < 50; i++) {
            assertThat(age(0.02, 0.04)).isBetween(0.0, 0.2);
        }
    }

    @Test
    void stampsWithoutSenseMakeNoMessageOlderThanTheConnectionAllows() {
        hear(50, 0.02);
        double ageS = 0;
        for (int i = 0; i < 1000; i++) {
            robotAheadS -= PERIOD_S * 0.9;
            ageS = age(0.02, 0.04);
        }

        assertThat(ageS).isLessThan(0.6);
    }

    @Test
    void timesDoNotGoBack() {
        long first = clock.measuredNanos(message(100), 1_000_000_000, 0.5);

        assertThat(clock.measuredNanos(message(100), 1_040_000_000, 0.5)).isGreaterThanOrEqualTo(first);
    }

    @Test
    void messagesWithoutAStampAndThoseOfASimulatedTimeWereMeasuredWhenTheyArrived() {
        assertThat(clock.measuredNanos(JsonNodeFactory.instance.objectNode(), 7, 0.5))
                .isEqualTo(7);
        assertThat(clock.measuredNanos(message(0), 8, 0.5)).isEqualTo(8);
        assertThat(new StampClock(false).measuredNanos(message(100), 9, 0.5)).isEqualTo(9);
    }
}

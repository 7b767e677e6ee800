package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import majic.time.TimeSource;
import org.junit.jupiter.api.Test;

/** When each of several things last happened. */
class LastTimesTest {
    private final LastTimes<String> reads = new LastTimes<>(TimeSource.system());

    @Test
    void anEventThatNeverOccurredIsInfinitelyLongAgo() {
        assertThat(reads.secondsSince("camera")).isInfinite();
    }

    @Test
    void onlyRecentKeysAreListed() {
        reads.record("camera");

        assertThat(reads.secondsSince("camera")).isBetween(0.0, 60.0);
        assertThat(reads.within(60)).containsExactly("camera");
        assertThat(reads.within(-1)).isEmpty();
        assertThat(reads.secondsSince("camera")).isInfinite();
    }

    @Test
    void clearingForgetsAll() {
        reads.record("camera");
        reads.clear();

        assertThat(reads.within(60)).isEmpty();
    }
}

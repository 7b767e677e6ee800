package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.drivertest.TestClock;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class DogClockTest {
    private static final long AHEAD_MS = 50_000;

    @AutoClose
    private final TestClock time = new TestClock();

    private final DogClock clock = new DogClock(time.time());

    @Test
    void aWordIsNoNewerThanItsTimeStamp() throws InterruptedException {
        clock.received(AHEAD_MS + nowMs());
        time.time().sleep(1);

        assertThat(clock.estimateMs()).isCloseTo(AHEAD_MS + nowMs(), within(1.0));
        assertThat(clock.roundTripS()).isZero();
    }

    @Test
    void twoSecondsOfDelayCostOneOfCertaintyWhicheverWayTheyArise() throws InterruptedException {
        long askedNanos = time.time().nanos();
        long saidMs = AHEAD_MS + nowMs();
        time.time().sleep(2);
        clock.received(saidMs);
        clock.answered(saidMs, askedNanos);

        assertThat(clock.estimateMs()).isCloseTo(AHEAD_MS + nowMs(), within(1001.0));
        assertThat(clock.roundTripS()).isCloseTo(2, within(0.01));
    }

    @Test
    void aShortRoundTripHoldsWhileLaterOnesAreSlow() throws InterruptedException {
        exchange(0.01);
        exchange(2);

        assertThat(clock.estimateMs()).isCloseTo(AHEAD_MS + nowMs(), within(10.0));
        assertThat(clock.roundTripS()).isLessThan(0.02);
    }

    @Test
    void aTimeStampThatCannotBeIsLeftOut() throws InterruptedException {
        exchange(0.01);

        clock.received(10 * AHEAD_MS);
        clock.answered(7, time.time().nanos());

        assertThat(clock.estimateMs()).isCloseTo(AHEAD_MS + nowMs(), within(10.0));
    }

    @Test
    void aFirstTimeStampThatWasGarbledMisleadsForThreeAnswersAtMost() throws InterruptedException {
        clock.received(10 * AHEAD_MS);

        exchange(0.01);
        exchange(0.01);
        assertThat(clock.estimateMs()).isGreaterThan(9.0 * AHEAD_MS);
        exchange(0.01);

        assertThat(clock.estimateMs()).isCloseTo(AHEAD_MS + nowMs(), within(10.0));
    }

    @Test
    void aFirstAnswerWhoseTimeStampWasGarbledMisleadsForThreeWordsAtMost() throws InterruptedException {
        clock.answered(7, time.time().nanos());
        time.time().sleep(0.1);

        for (int word = 0; word < 3; word++) {
            clock.received(AHEAD_MS + nowMs());
        }

        assertThat(clock.estimateMs()).isCloseTo(AHEAD_MS + nowMs(), within(10.0));
    }

    @Test
    void oldBoundsAreForgotten() throws InterruptedException {
        exchange(0.01);
        time.time().sleep(11);
        exchange(1);
        time.time().sleep(11);
        exchange(1);

        assertThat(clock.roundTripS()).isGreaterThan(0.5);
    }

    private void exchange(double seconds) throws InterruptedException {
        long askedNanos = time.time().nanos();
        time.time().sleep(seconds);
        long saidMs = AHEAD_MS + nowMs();
        clock.received(saidMs);
        clock.answered(saidMs, askedNanos);
    }

    private long nowMs() {
        return time.time().nanos() / 1_000_000;
    }
}

package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LinkMeterTest {
    private static final long MS = 1_000_000;

    private final LinkMeter link = new LinkMeter();
    private long nowMs = 1000;

    private void reportAfter(long ms) {
        nowMs += ms;
        link.reported(nowMs * MS);
    }

    private void reportRegularly(int times, long everyMs) {
        for (int time = 0; time < times; time++) {
            reportAfter(everyMs);
        }
    }

    @Test
    void beforeTheFirstReportNothingIsOverdue() {
        assertThat(link.overdueS(90_000 * MS)).isEmpty();
        assertThat(link.bars(90_000 * MS)).isEqualTo(LinkMeter.MOST_BARS);
    }

    @Test
    void regularReportsHaveAllBars() {
        reportRegularly(30, 100);
        assertThat(link.bars((nowMs + 100) * MS)).isEqualTo(3);
        assertThat(link.overdueS((nowMs + 100) * MS)).isEmpty();
    }

    @Test
    void aRobotThatReportsRarelyHasAllBarsToo() {
        reportRegularly(30, 2000);
        assertThat(link.bars((nowMs + 5000) * MS)).isEqualTo(3);
    }

    @Test
    void aReportIsOverdueAfterThreeTimesTheNormalInterval() {
        reportRegularly(30, 500);
        assertThat(link.overdueS((nowMs + 1400) * MS)).isEmpty();
        assertThat(link.overdueS((nowMs + 1600) * MS)).hasValue(1.6);
    }

    @Test
    void aGapCostsBarsUntilItIsForgotten() {
        reportRegularly(30, 100);
        reportAfter(1000);
        assertThat(link.bars(nowMs * MS)).isEqualTo(2);
        reportAfter(4000);
        assertThat(link.bars(nowMs * MS)).isEqualTo(1);
        reportRegularly(30, 100);
        assertThat(link.bars(nowMs * MS)).isEqualTo(3);
    }

    @Test
    void withoutReportsThereAreNoBars() {
        reportRegularly(30, 100);
        assertThat(link.bars((nowMs + 10_000) * MS)).isZero();
    }

    @Test
    void afterReconnectingTheTimeWithoutConnectionDoesNotCount() {
        reportRegularly(30, 100);
        link.clear();
        reportAfter(60_000);
        assertThat(link.bars(nowMs * MS)).isEqualTo(3);
    }
}

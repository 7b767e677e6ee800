package majic.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class SuspendDetectorTest {
    private final AtomicLong wallMs = new AtomicLong(1_800_000_000_000L);
    private final AtomicLong nanos = new AtomicLong(-5_000_000_000L);
    private final SuspendDetector slumber = new SuspendDetector(wallMs::get, nanos::get);

    @Test
    void aWaitIsNoSlumber() {
        pass(60_000, 60_000);
        assertThat(slumber.wasSuspended()).isFalse();
    }

    @Test
    void aMinuteOnTheWallClockAloneIsDetectedOnce() {
        pass(60_000, 20);
        assertThat(slumber.wasSuspended()).isTrue();
        assertThat(slumber.wasSuspended()).isFalse();
    }

    @Test
    void aClockThatIsSetBackOrCorrectedALittleIsNone() {
        pass(20, 60_000);
        assertThat(slumber.wasSuspended()).isFalse();
        pass(520, 20);
        assertThat(slumber.wasSuspended()).isFalse();
    }

    private void pass(long onTheWallMs, long inProgramsMs) {
        wallMs.addAndGet(onTheWallMs);
        nanos.addAndGet(inProgramsMs * 1_000_000);
    }
}

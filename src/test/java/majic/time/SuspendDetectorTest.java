package majic.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class SuspendDetectorTest {
    private final AtomicLong wallMs = new AtomicLong(1_800_000_000_000L);
    private final AtomicLong nanos = new AtomicLong(-5_000_000_000L);
    private final SuspendDetector detector = new SuspendDetector(wallMs::get, nanos::get);

    @Test
    void aWaitIsNoSuspension() {
        pass(60_000, 60_000);
        assertThat(detector.wasSuspended()).isFalse();
    }

    @Test
    void aMinuteThatPassesOnTheWallClockOnlyIsDetectedOnce() {
        pass(60_000, 20);
        assertThat(detector.wasSuspended()).isTrue();
        assertThat(detector.wasSuspended()).isFalse();
    }

    @Test
    void aWallClockThatIsSetBackOrCorrectedALittleIsNoSuspension() {
        pass(20, 60_000);
        assertThat(detector.wasSuspended()).isFalse();
        pass(520, 20);
        assertThat(detector.wasSuspended()).isFalse();
    }

    @Test
    void clocksThatDriftApartWhileNothingIsAskedForHoursAreNoSuspension() {
        pass(36_001_500, 36_000_000);
        assertThat(detector.wasSuspended()).isFalse();
        pass(61_500, 1500);
        assertThat(detector.wasSuspended()).isTrue();
    }

    private void pass(long onTheWallMs, long inProgramsMs) {
        wallMs.addAndGet(onTheWallMs);
        nanos.addAndGet(inProgramsMs * 1_000_000);
    }
}

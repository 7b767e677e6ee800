package majicsim.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class FirmwareClockTest {
    private static final long STEP_NANOS = 4_000_000;

    private final Sleeper firmware = new Sleeper();
    private final LabTime time = new LabTime();
    private final FirmwareClock clock = new FirmwareClock(firmware, time);

    @Test
    void aFirmwareAtWorkTakesEachStep() {
        step(1, 3);
        assertThat(firmware.events).containsExactly("step 4", "step 4", "step 4");
    }

    @Test
    void theStepsOfARestAreMadeUpForBeforeTheStepThatIsDue() {
        firmware.restMs = 12;
        step(1, 7);
        assertThat(firmware.events).containsExactly("step 4", "rest 8", "step 4", "rest 8", "step 4");
    }

    @Test
    void aUseEndsTheRest() {
        firmware.restMs = 100;
        step(1, 3);
        clock.wake();
        clock.wake();
        step(4, 4);
        assertThat(firmware.events).containsExactly("step 4", "rest 8", "step 4");
    }

    @Test
    void aRestWithoutEndIsInterruptedNowAndThen() {
        firmware.restMs = Long.MAX_VALUE / 1_000_000;
        step(1, 26);
        assertThat(firmware.events).containsExactly("step 4", "rest 96", "step 4");
    }

    private void step(int from, int to) {
        for (int number = from; number <= to; number++) {
            time.step(STEP_NANOS);
        }
    }

    private static final class Sleeper implements Firmware {
        private final List<String> events = new ArrayList<>();
        private long restMs;

        @Override
        public void received(Line line, byte[] bytes) {}

        @Override
        public void step(double seconds) {
            events.add("step " + Math.round(seconds * 1000));
        }

        @Override
        public long restNanos() {
            return restMs * 1_000_000;
        }

        @Override
        public void rest(long nanos) {
            events.add("rest " + nanos / 1_000_000);
        }
    }
}

package majicsim.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.world.Noise;
import org.junit.jupiter.api.Test;

class DelayedBytesTest {
    private static final long STEP_NANOS = 4_000_000;

    private final LabTime time = new LabTime();
    private final Faults faults = new Faults(Noise.exact(), time);
    private final List<String> left = new ArrayList<>();
    private final DelayedBytes bytes = new DelayedBytes(
            new Wiring(new ReentrantLock(), new EchoFirmware(), faults),
            false,
            some -> left.add(new String(some, StandardCharsets.US_ASCII)));

    @Test
    void messagesOfOneStepThatAreDelayedLeaveTogether() {
        faults.delay(4);
        enter("SIP,");
        enter("inputs,");
        enter("gyro");
        assertThat(left).isEmpty();

        step();
        assertThat(left).containsExactly("SIP,inputs,gyro");
    }

    @Test
    void messagesOfDifferentStepsLeaveApartAndInOrder() {
        faults.delay(8);
        enter("first");
        step();
        enter("second");
        faults.none();
        step();
        step();
        assertThat(left).containsExactly("first", "second");
    }

    @Test
    void halvesOfAMessageLeaveApart() {
        faults.halfPackets();
        faults.delay(4);
        enter("12345678");
        step();
        step();
        assertThat(left).containsExactly("1234", "5678");
    }

    @Test
    void messagesWithoutDelayLeaveAtOnce() {
        enter("first");
        enter("second");
        assertThat(left).containsExactly("first", "second");
    }

    @Test
    void aLineOfLimitedBandwidthCarriesOneMessageAfterTheOther() {
        faults.bandwidth(1000);
        enter("12345678");
        enter("abcd");
        step();
        assertThat(left).isEmpty();

        step();
        assertThat(left).containsExactly("12345678");
        step();
        assertThat(left).containsExactly("12345678", "abcd");
    }

    @Test
    void aLineOfLimitedBandwidthThatWasIdleIsFreeAtOnce() {
        faults.bandwidth(1000);
        enter("1234");
        step();
        step();
        step();
        enter("abcd");
        step();
        assertThat(left).containsExactly("1234", "abcd");
    }

    private void enter(String message) {
        bytes.enter(message.getBytes(StandardCharsets.US_ASCII));
    }

    private void step() {
        time.step(STEP_NANOS);
        bytes.release();
    }
}

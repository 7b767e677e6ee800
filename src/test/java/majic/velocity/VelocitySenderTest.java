package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;

/** The sender of velocities, without a base. */
class VelocitySenderTest {
    private final List<Double> published = new ArrayList<>();

    @Test
    void aStuckWriteHoldsUpNeitherQuestionsNorTheEndOfTheConnection() throws InterruptedException {
        CountDownLatch writing = new CountDownLatch(1);
        CountDownLatch written = new CountDownLatch(1);
        AtomicReference<InterruptedException> interrupted = new AtomicReference<>();
        VelocitySender sender = new VelocitySender(
                (mmPerSec, degPerSec) -> {
                    writing.countDown();
                    try {
                        written.await();
                    } catch (InterruptedException e) {
                        interrupted.set(e);
                    }
                },
                TimeSource.system(),
                (mmPerSec, degPerSec) -> {});
        Thread writer = new Thread(() -> sender.send(100, 0), "writer");
        writer.start();
        writing.await();

        assertThat(sender.isMoving()).isTrue();
        assertThat(sender.isStopping()).isFalse();
        assertThat(sender.isActive()).isTrue();
        sender.end();
        assertThat(sender.isActive()).isFalse();

        written.countDown();
        writer.join();
        assertThat(interrupted).hasValue(null);
    }

    @Test
    void aStopIsRepeatedUntilItIsEnded() {
        VelocitySender sender = sender();

        sender.send(100, 0);
        sender.stop();
        sender.repeat();
        sender.repeat();
        sender.endStop();
        sender.repeat();

        assertThat(published).containsExactly(100.0, 0.0, 0.0, 0.0);
        assertThat(sender.stopsSent()).isEqualTo(3);
    }

    @Test
    void nothingIsRepeatedOnceTheConnectionHasEnded() {
        VelocitySender sender = sender();

        sender.stop();
        sender.end();
        sender.repeat();

        assertThat(published).containsExactly(0.0);
    }

    private VelocitySender sender() {
        return new VelocitySender(
                (mmPerSec, degPerSec) -> published.add(mmPerSec), TimeSource.system(), (mmPerSec, degPerSec) -> {});
    }
}

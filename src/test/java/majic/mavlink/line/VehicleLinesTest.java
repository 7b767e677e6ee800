package majic.mavlink.line;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.drivertest.TestClock;
import majic.link.Link;
import majic.link.Traffic;
import majic.mavlink.frame.MavlinkFrame;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Who opens and closes a port that several robots share, and in which order. */
class VehicleLinesTest {
    @AutoClose
    private final TestClock clock = new TestClock();

    private final List<String> events = new CopyOnWriteArrayList<>();
    private final CountDownLatch closing = new CountDownLatch(1);
    private final CountDownLatch mayClose = new CountDownLatch(1);
    private volatile boolean closesSlowly;
    private volatile boolean used;
    private volatile Port newest;

    /** The port, which can be open only once. */
    private final class Port implements Link {
        private final CountDownLatch ended = new CountDownLatch(1);
        private boolean closed;

        Port() {
            newest = this;
        }

        @Override
        public void open(int timeoutMs) throws IOException {
            if (used) {
                throw new IOException("the port is used");
            }
            used = true;
            events.add("opened");
        }

        @Override
        public int read(byte[] buffer) {
            await(ended);
            return -1;
        }

        @Override
        public void write(byte[] message) {
            // Nothing is sent in these tests.
        }

        @Override
        public void close() {
            if (closed) {
                return;
            }
            closed = true;
            ended.countDown();
            if (closesSlowly) {
                closesSlowly = false;
                closing.countDown();
                await(mayClose);
            }
            events.add("closed");
            used = false;
        }

        @Override
        public void abort() {
            close();
        }

        @Override
        public String address() {
            return "serial:/dev/test";
        }

        @Override
        public Traffic traffic() {
            throw new UnsupportedOperationException();
        }
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private record User(int system) implements FrameListener {
        @Override
        public void received(MavlinkFrame frame) {
            // Nothing is received in these tests.
        }

        @Override
        public void ignored(int system, String address) {
            // Nothing is received in these tests.
        }

        @Override
        public void ended(IOException cause) {
            // Only the order of opening and closing is tested.
        }
    }

    private VehicleEndpoint port(int baud) {
        return new VehicleEndpoint("serial:/dev/test", "/dev/test", false, baud, Port::new);
    }

    private VehicleLine join(int baud, int system) throws IOException {
        return VehicleLines.join(port(baud), 1000, clock.time(), new User(system));
    }

    @Test
    void theLastUserClosesThePort() throws IOException {
        VehicleLine one = join(57_600, 1);
        VehicleLine two = join(57_600, 2);
        assertThat(events).containsExactly("opened");

        one.close();
        assertThat(events).containsExactly("opened");

        two.close();
        assertThat(events).containsExactly("opened", "closed");
    }

    @Test
    void aPortThatIsBeingClosedIsOpenedAgainWhenItIsClosed() throws Exception {
        VehicleLine old = join(57_600, 1);
        closesSlowly = true;
        Thread leaving = new Thread(old::close, "leaving");
        leaving.start();
        await(closing);

        CompletableFuture<VehicleLine> joined = joinWhileItCloses();

        VehicleLine second = joined.join();
        assertThat(events).containsExactly("opened", "closed", "opened");
        leaving.join();
        second.close();
        assertThat(events).containsExactly("opened", "closed", "opened", "closed");
    }

    /** Joins from another thread, and lets the old port close as soon as that thread waits for it or has failed. */
    private CompletableFuture<VehicleLine> joinWhileItCloses() {
        CompletableFuture<VehicleLine> joined = new CompletableFuture<>();
        Thread joining = new Thread(
                () -> joined.completeAsync(
                        () -> {
                            try {
                                return join(57_600, 2);
                            } catch (IOException e) {
                                throw new IllegalStateException(e);
                            }
                        },
                        Runnable::run),
                "joining");
        joining.start();
        while (!joined.isDone() && joining.getState() != Thread.State.BLOCKED) {
            Thread.onSpinWait();
        }
        mayClose.countDown();
        return joined;
    }

    @Test
    void aPortThatHasEndedIsOpenedAgainWhenItIsClosed() throws Exception {
        VehicleLine old = join(57_600, 1);
        closesSlowly = true;
        newest.ended.countDown();
        await(closing);

        VehicleLine second = joinWhileItCloses().join();

        assertThat(events).containsExactly("opened", "closed", "opened");
        old.close();
        assertThat(events).containsExactly("opened", "closed", "opened");
        second.close();
        assertThat(events).containsExactly("opened", "closed", "opened", "closed");
    }

    @Test
    void anotherSpeedThanThatOfTheOpenPortIsRefused() throws IOException {
        List<VehicleLine> open = List.of(join(57_600, 1), join(57_600, 2));

        assertThatThrownBy(() -> join(115_200, 3))
                .isInstanceOf(IOException.class)
                .hasMessage("the serial port /dev/test is open at 57600 baud for vehicle 1, 2, and has one"
                        + " speed: use ?baud=57600 in both addresses, or disconnect that robot first");

        open.forEach(VehicleLine::close);
    }

    @Test
    void anotherSpeedIsAcceptedWhenThePortWasClosed() throws IOException {
        join(57_600, 1).close();

        join(115_200, 1).close();

        assertThat(events).containsExactly("opened", "closed", "opened", "closed");
    }
}

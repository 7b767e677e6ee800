package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import majic.bot.LinkLost;
import majic.drivertest.TestClock;
import majic.time.Signal;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** The watch of one connection beside a server that answers as the test says. */
class ServerWatchTest {
    @AutoClose
    private final TestClock clock = new TestClock();

    private final TimeSource time = clock.time();

    @Test
    void aServerThatAnswersIsPingedFourTimesASecond() {
        FakeServer server = new FakeServer(time);

        try (ServerWatch watch = new ServerWatch(time, server, server::silent)) {
            watch.start();
            pass(10.1);
        }

        assertThat(server.pings).hasValueBetween(39, 41);
        assertThat(server.silences).hasValue(0);
    }

    @Test
    void theSilenceIsReportedOnceAndThenNothingIsSent() {
        FakeServer server = new FakeServer(time);
        server.answers = false;
        ServerWatch watch = new ServerWatch(time, server, server::silent);
        watch.start();

        pass(0.85);
        assertThat(server.silences).hasValue(0);
        pass(0.1);
        assertThat(server.silences).hasValue(1);
        int sent = server.pings.get();
        pass(5);

        assertThat(server.silences).hasValue(1);
        assertThat(server.pings).hasValue(sent);
    }

    @Test
    void timeByWhichItIsWokenTooLateDoesNotCount() {
        TimeSource late = new LateTime(time, 0.5);
        FakeServer server = new FakeServer(time);
        server.answers = false;

        new ServerWatch(late, server, server::silent).start();

        pass(1.5);
        assertThat(server.silences).hasValue(0);
        pass(3);
        assertThat(server.silences).hasValue(1);
    }

    @Test
    void theEndOfTheConnectionIsLeftToItsReader() {
        FakeServer server = new FakeServer(time);
        server.ended = true;

        new ServerWatch(time, server, server::silent).start();
        pass(5);

        assertThat(server.pings).hasValue(1);
        assertThat(server.silences).hasValue(0);
    }

    @Test
    void aClosedWatchSendsNothing() {
        FakeServer server = new FakeServer(time);
        ServerWatch watch = new ServerWatch(time, server, server::silent);
        watch.start();
        pass(1.1);

        watch.close();
        int sent = server.pings.get();
        pass(3);

        assertThat(server.pings).hasValue(sent);
        assertThat(server.silences).hasValue(0);
    }

    private void pass(double seconds) {
        long from = time.nanos();
        clock.until(() -> time.secondsSince(from) >= seconds);
    }

    /**
     * A clock that wakes each thread too late, as on a busy computer.
     *
     * @param clock the right one
     * @param lateS by which all waits are longer
     */
    private record LateTime(TimeSource clock, double lateS) implements TimeSource {
        @Override
        public long nanos() {
            return clock.nanos();
        }

        @Override
        public Signal signal() {
            Signal signal = clock.signal();
            return new Signal() {
                @Override
                public boolean await(BooleanSupplier condition, double seconds) throws InterruptedException {
                    return signal.await(condition, seconds + lateS);
                }

                @Override
                public void raise() {
                    signal.raise();
                }
            };
        }

        @Override
        public Thread thread(String name, Runnable body) {
            return clock.thread(name, body);
        }

        @Override
        public Membership join() {
            return clock.join();
        }
    }

    private static final class FakeServer implements ServerWatch.Server {
        private final TimeSource time;
        final AtomicInteger pings = new AtomicInteger();
        final AtomicInteger silences = new AtomicInteger();
        volatile boolean answers = true;
        volatile boolean ended;
        private volatile long heardNanos;

        FakeServer(TimeSource time) {
            this.time = time;
            heardNanos = time.nanos();
        }

        void silent() {
            silences.incrementAndGet();
        }

        @Override
        public void ping() {
            pings.incrementAndGet();
            if (ended) {
                throw new LinkLost("it has ended");
            }
            if (answers) {
                heardNanos = time.nanos();
            }
        }

        @Override
        public double silenceS() {
            return time.secondsSince(heardNanos);
        }
    }
}

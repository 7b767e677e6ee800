package majic.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.Mockito.mock;

import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import majic.bot.FakeBot;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/**
 * Tests that a robot can still be stopped when the system has no thread left, for instance because an act uses them
 * all.
 */
class NoThreadsLeftTest {
    private final Exhaustible time = new Exhaustible();
    private final Team team = new Team(time);

    @AfterEach
    void close() {
        time.exhausted = false;
        team.close();
    }

    /** The system's clock, in a system that may be unable to create threads. */
    private static final class Exhaustible implements TimeSource {
        private volatile boolean exhausted;

        @Override
        public long nanos() {
            return TimeSource.system().nanos();
        }

        @Override
        public Signal signal() {
            return TimeSource.system().signal();
        }

        @Override
        public Thread thread(String name, Runnable body) {
            return exhausted ? new Refused() : TimeSource.system().thread(name, body);
        }

        @Override
        public Membership join() {
            return TimeSource.system().join();
        }
    }

    /** The behaviour of thread creation in that case. */
    private static final class Refused extends Thread {
        @Override
        public synchronized void start() {
            throw new OutOfMemoryError("unable to create native thread");
        }
    }

    @Test
    void everyRobotIsStopped() {
        FakeBot first = join();
        FakeBot second = join();
        time.exhausted = true;

        team.stopAll();

        assertThat(first.sent()).containsExactly("halt");
        assertThat(second.sent()).containsExactly("halt");
    }

    @Test
    void everyRobotIsStoppedThoughAListenerBlocks() {
        FakeBot first = join();
        FakeBot second = join();
        CountDownLatch testIsOver = new CountDownLatch(1);
        team.addListener(mock(TeamListener.class, call -> {
            await(testIsOver);
            return null;
        }));
        time.exhausted = true;

        CompletableFuture<Void> stop = CompletableFuture.runAsync(team::stopAll, task -> new Thread(task).start());

        WaitLimit.until(
                "both stops",
                () -> first.sent().contains("halt") && second.sent().contains("halt"));
        testIsOver.countDown();
        WaitLimit.join("the stop", stop);
    }

    @Test
    void aHandThatCannotDriveLeavesTheRobotFree() {
        join();
        time.exhausted = true;

        assertThatThrownBy(() -> new ManualControl(team.member(1))).hasMessageContaining("no thread left");
        assertThat(team.member(1).owner()).isNull();
    }

    @Test
    void everyRobotIsClosed() {
        FakeBot first = join();
        FakeBot second = join();
        time.exhausted = true;

        team.close();

        assertThat(first.sent()).contains("close");
        assertThat(second.sent()).contains("close");
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private FakeBot join() {
        FakeBot bot = FakeBot.on(time);
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }
}

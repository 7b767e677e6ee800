package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import majic.bot.FakeBot;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class EarlyStopTest {
    private final FakeBot bot = FakeBot.on(TimeSource.system());
    private final CountDownLatch sending = new CountDownLatch(1);
    private final CountDownLatch stuck = new CountDownLatch(1);
    private final CountDownLatch toldAhead = new CountDownLatch(1);

    @BeforeEach
    void connect() {
        bot.connect();
        bot.sendDrivesThrough(() -> {
            sending.countDown();
            await(stuck);
        });
        bot.whenStoppedAhead(toldAhead::countDown);
    }

    @AfterEach
    void close() {
        stuck.countDown();
        bot.close();
    }

    @Test
    void aStopGoesAheadOfACommandThatIsStuckAndOnceMoreBehindIt() {
        CompletableFuture<Void> drive = aside(() -> bot.drive(100, 0));
        await(sending);

        CompletableFuture<Void> stop = aside(bot::stop);

        await(toldAhead);
        assertThat(bot.sent()).isEmpty();
        stuck.countDown();
        WaitLimit.join("drive and stop", CompletableFuture.allOf(drive, stop));
        assertThat(bot.sent()).containsExactly("drive 100 0", "halt");
    }

    @Test
    void theOrdinaryStopFollowsAlsoWhenTheEarlyOneFails() {
        bot.whenStoppedAhead(() -> {
            throw new LinkLost("the stop's own line is gone");
        });

        bot.stop();

        assertThat(bot.sent()).containsExactly("halt");
    }

    @Test
    void nothingIsSentBehindTheFarewell() {
        CompletableFuture<Void> drive = aside(() -> bot.drive(100, 0));
        await(sending);

        CompletableFuture<Void> close = aside(bot::close);
        awaitClosing();
        stuck.countDown();

        WaitLimit.join("drive and close", CompletableFuture.allOf(drive, close));
        assertThat(bot.sent()).containsExactly("drive 100 0", "halt", "close");
    }

    /** On a thread of its own: the common pool may have just one. */
    private static CompletableFuture<Void> aside(Runnable work) {
        return CompletableFuture.runAsync(work, task -> new Thread(task).start());
    }

    private void awaitClosing() {
        while (bot.connection() != MajicBot.Connection.CLOSED) {
            assertThat(Thread.currentThread().isInterrupted()).isFalse();
            LockSupport.parkNanos(100_000);
        }
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}

package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import majic.aibo.urbi.UrbiConnection;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class StopPathTest {
    private static final int MOTION = 2;

    private final TimeSource time = TimeSource.system();

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standingInRealTime().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void aStopArrivesAtOnceThoughACommandIsStuckOnTheMotionConnection() throws InterruptedException {
        dog.stopReading(MOTION);
        fill(aibo.session().connections().motion());
        CompletableFuture<Void> drive = aside(() -> aibo.drive(50, 0));
        until(() -> aibo.session().executor().current() != null);

        CompletableFuture<Void> stop = aside(this::stop);
        dog.awaitReceived("stop walk");

        assertThat(drive).isNotDone();
        WaitLimit.join("the stop", stop);
    }

    /** On a thread of its own: the common pool may have just one. */
    private static CompletableFuture<Void> aside(Runnable work) {
        return CompletableFuture.runAsync(work, task -> new Thread(task).start());
    }

    /** Writes until nothing more goes out. */
    private void fill(UrbiConnection connection) throws InterruptedException {
        AtomicLong written = new AtomicLong();
        time.thread("filler", () -> fill(connection, written)).start();
        long before;
        do {
            before = written.get();
            time.signal().await(() -> false, 0.1);
        } while (written.get() != before || before == 0);
    }

    private static void fill(UrbiConnection connection, AtomicLong written) {
        try {
            while (true) {
                connection.send("/*" + "x".repeat(30_000) + "*/");
                written.incrementAndGet();
            }
        } catch (LinkLost e) {
            written.set(-1);
        }
    }

    private void until(BooleanSupplier so) throws InterruptedException {
        Signal never = time.signal();
        while (!never.await(so, 0.01)) {
            assertThat(aibo.isConnected()).isTrue();
        }
    }

    /** The dog never confirms it: its motion connection is dead a moment later. */
    private void stop() {
        try {
            aibo.stop();
        } catch (BotException e) {
            assertThat(e).isInstanceOf(LinkLost.class);
        }
    }
}

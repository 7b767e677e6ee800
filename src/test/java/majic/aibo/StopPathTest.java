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
import org.junit.jupiter.api.Test;

class StopPathTest {
    private static final int MOTION = 2;

    /** A busy computer may not get to the stop within the second after which the stuck connection is ended. */
    private static final int ATTEMPTS = 30;

    private final TimeSource time = TimeSource.system();

    @Test
    void aStopArrivesAtOnceThoughACommandIsStuckOnTheMotionConnection() throws Exception {
        boolean arrived = false;
        for (int attempt = 0; !arrived && attempt < ATTEMPTS; attempt++) {
            try (DrivenAibo driven = DrivenAibo.standingInRealTime().connected()) {
                arrived = arrivesWhileACommandIsStuck(driven.dog, driven.aibo);
            }
        }

        assertThat(arrived).isTrue();
    }

    private boolean arrivesWhileACommandIsStuck(ScriptedDog dog, MajicAibo aibo) throws InterruptedException {
        dog.stopReading(MOTION);
        fill(aibo.session().connections().motion());
        CompletableFuture<Void> drive = aside(() -> aibo.drive(50, 0));
        until(() -> drive.isDone() || isDriving(aibo));

        CompletableFuture<Void> stop = aside(() -> stop(aibo));
        until(() -> drive.isDone() || !dog.received("stop walk").isEmpty());

        boolean arrived = !drive.isDone();
        WaitLimit.join("the stop", stop);
        return arrived;
    }

    private static boolean isDriving(MajicAibo aibo) {
        try {
            return aibo.session().executor().current() != null;
        } catch (LinkLost e) {
            return false;
        }
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
            assertThat(Thread.currentThread().isInterrupted()).isFalse();
        }
    }

    /** The dog never confirms it: its motion connection is dead a moment later. */
    private static void stop(MajicAibo aibo) {
        try {
            aibo.stop();
        } catch (BotException e) {
            assertThat(e).isInstanceOf(LinkLost.class);
        }
    }
}

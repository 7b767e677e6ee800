package majic.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class WriteDeadlineTest {
    /** A link of which only the end matters. */
    private record Ending(Runnable abortion) implements Link {
        @Override
        public void open(int timeoutMs) {}

        @Override
        public int read(byte[] buffer) {
            return -1;
        }

        @Override
        public void write(byte[] message) {}

        @Override
        public void close() {}

        @Override
        public void abort() {
            abortion.run();
        }

        @Override
        public String address() {
            return "test";
        }

        @Override
        public Traffic traffic() {
            return new Traffic("", "", 0, 0, false);
        }
    }

    @Test
    void aLinkWhoseAbortBlocksDelaysNoOtherLink() throws InterruptedException {
        CountDownLatch over = new CountDownLatch(1);
        CountDownLatch aborted = new CountDownLatch(1);
        WriteDeadline.start(new Ending(() -> hang(over)));

        WriteDeadline.start(new Ending(aborted::countDown));

        aborted.await();
        over.countDown();
    }

    @Test
    void aWriteThatReturnsInTimeAbortsNothing() throws InterruptedException {
        CountDownLatch early = new CountDownLatch(1);
        CountDownLatch late = new CountDownLatch(1);
        WriteDeadline.start(new Ending(early::countDown)).close();

        WriteDeadline.start(new Ending(late::countDown));

        late.await();
        assertThat(early.getCount()).isEqualTo(1);
    }

    @Test
    void everyWriteOfManyHasItsOwnDeadline() throws InterruptedException {
        for (int write = 0; write < 3; write++) {
            CountDownLatch aborted = new CountDownLatch(1);
            long begunNanos = System.nanoTime();
            WriteDeadline.start(new Ending(aborted::countDown));

            aborted.await();
            assertThat(System.nanoTime() - begunNanos)
                    .isGreaterThanOrEqualTo(TimeUnit.MILLISECONDS.toNanos(Link.WRITE_DEADLINE_MS));
        }
    }

    @Test
    void aWriteThatWasInProgressWhileTheProgramDidNotRunMayStillReturn() throws InterruptedException {
        CountDownLatch aborted = new CountDownLatch(1);
        WriteDeadline write = new WriteDeadline(new Ending(aborted::countDown), 0);
        long resumedNanos = TimeUnit.HOURS.toNanos(1);

        assertThat(write.leftNanos(resumedNanos)).isEqualTo(WriteDeadline.CONFIRM_NANOS);
        assertThat(write.leftNanos(resumedNanos + WriteDeadline.CONFIRM_NANOS - 1))
                .isEqualTo(1);
        assertThat(write.passed()).isFalse();

        write.leftNanos(resumedNanos + WriteDeadline.CONFIRM_NANOS);
        assertThat(write.passed()).isTrue();
        aborted.await();
    }

    private static void hang(CountDownLatch over) {
        try {
            over.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

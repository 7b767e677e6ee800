package majic.gui;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.Pipe;
import java.util.concurrent.CountDownLatch;
import javax.swing.SwingUtilities;

/** Keeps the event dispatch thread in one event, which reads from a pipe, until this is closed. */
final class BusyEventThread implements AutoCloseable {
    private final Pipe pipe = open();
    private final CountDownLatch reading = new CountDownLatch(1);
    private final CountDownLatch done = new CountDownLatch(1);

    private BusyEventThread() {}

    /** Returns when the thread is busy. */
    static BusyEventThread begin() throws InterruptedException {
        BusyEventThread busy = new BusyEventThread();
        SwingUtilities.invokeLater(busy::read);
        busy.reading.await();
        return busy;
    }

    private static Pipe open() {
        try {
            return Pipe.open();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void read() {
        try (Pipe.SourceChannel source = pipe.source()) {
            reading.countDown();
            source.read(ByteBuffer.allocate(1));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            done.countDown();
        }
    }

    boolean isBusy() {
        return done.getCount() > 0;
    }

    /** Lets the thread go on, and returns when it does. */
    @Override
    public void close() throws IOException {
        pipe.sink().close();
        try {
            done.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

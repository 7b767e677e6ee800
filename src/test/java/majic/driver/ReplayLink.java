package majic.driver;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CountDownLatch;
import majic.link.Link;
import majic.link.Traffic;

/** A link whose peer sends some messages, each in one piece, and then closes. */
public final class ReplayLink implements Link {
    private final Queue<byte[]> messages;
    private final CountDownLatch closed = new CountDownLatch(1);

    /** With what its peer sends. */
    public ReplayLink(byte[]... messages) {
        this.messages = new ArrayDeque<>(List.of(messages));
    }

    /** Waits until the driver has closed it, without a timeout of its own. */
    public void awaitClose() throws InterruptedException {
        closed.await();
    }

    @Override
    public void open(int timeoutMs) {}

    @Override
    public int read(byte[] buffer) {
        byte[] message = messages.poll();
        if (message == null) {
            return -1;
        }
        System.arraycopy(message, 0, buffer, 0, message.length);
        return message.length;
    }

    @Override
    public void write(byte[] message) {}

    @Override
    public void close() {
        closed.countDown();
    }

    @Override
    public void abort() {
        close();
    }

    @Override
    public String address() {
        return "tcp:robot";
    }

    @Override
    public Traffic traffic() {
        return new Traffic("here", "there", 0, 0, true);
    }
}

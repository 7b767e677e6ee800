package liburbi.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.concurrent.locks.LockSupport;
import liburbi.UClient;
import liburbi.parser.UParser;

/**
 * Reads on a thread of its own, which dies of whatever a listener throws, reports no error and notices no end of the
 * stream.
 */
public class SocketClient implements Runnable {
    private final UParser parser;
    private final Selector selector;
    private SocketChannel channel;

    public SocketClient(UClient client) {
        parser = new UParser(client);
        try {
            selector = Selector.open();
            channel = SocketChannel.open();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    public SocketChannel getChannel() {
        return channel;
    }

    public void setSocketChannel(SocketChannel socket) {
        channel = socket;
    }

    public void start() {
        Thread thread = new Thread(this, "SocketClient");
        thread.setDaemon(true);
        thread.start();
    }

    public void disconnect() {
        try {
            selector.close();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    public void run() {
        try {
            channel.register(selector, SelectionKey.OP_READ);
            while (selector.select() > 0) {
                selector.selectedKeys().clear();
                read();
            }
        } catch (IOException e) {
            return;
        }
    }

    private void read() throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(64 * 1024);
        int count = channel.read(buffer);
        if (count < 0) {
            LockSupport.parkNanos(1_000_000);
        }
        buffer.flip();
        while (buffer.hasRemaining()) {
            parser.take(buffer.get());
        }
    }
}

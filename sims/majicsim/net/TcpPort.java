package majicsim.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A TCP port on loopback behind which a firmware listens. One daemon thread accepts, reads and writes what a socket did not take at
 * once; it takes the lab's lock for every call of the firmware.
 */
public final class TcpPort implements Port {
    private static final System.Logger LOG = System.getLogger(TcpPort.class.getName());
    private static final int JOIN_MS = 1000;

    private final ServerSocketChannel server;
    private final Selector selector;
    private final Clients clients;
    private final Wiring wiring;
    private final List<TcpLine> lines = new CopyOnWriteArrayList<>();
    private final ByteBuffer chunk = ByteBuffer.allocate(4096);
    private final Thread thread;

    private TcpPort(ServerSocketChannel server, Selector selector, Clients clients, Wiring wiring) {
        this.server = server;
        this.selector = selector;
        this.clients = clients;
        this.wiring = wiring;
        this.thread = new Thread(this::serve, "lab-port-" + server.socket().getLocalPort());
        thread.setDaemon(true);
    }

    /**
     * Opens a port and begins to serve it.
     *
     * @param port TCP port on loopback, 0 for any free one
     * @param clients how many at a time
     * @param wiring lock, firmware and faults
     * @return the open port
     * @throws IOException if the port is taken ({@link java.net.BindException}) or cannot be opened
     */
    public static TcpPort open(int port, Clients clients, Wiring wiring) throws IOException {
        ServerSocketChannel server = ServerSocketChannel.open();
        try {
            server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
            server.configureBlocking(false);
            Selector selector = Selector.open();
            server.register(selector, SelectionKey.OP_ACCEPT);
            return new TcpPort(server, selector, clients, wiring).start();
        } catch (IOException e) {
            server.close();
            throw e;
        }
    }

    /**
     * Its number.
     *
     * @return 1 to 65535
     */
    public int number() {
        return server.socket().getLocalPort();
    }

    @Override
    public String address() {
        return "127.0.0.1:" + number();
    }

    @Override
    public void step(long labNanos) {
        wiring.faults().tick(labNanos);
        for (TcpLine line : lines) {
            line.release();
            if (line.isOver()) {
                selector.wakeup();
            }
        }
    }

    @Override
    public List<LineCount> lines() {
        return lines.stream().map(RobotLine::count).toList();
    }

    @Override
    public void close() {
        try {
            server.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing {0}: {1}", address(), e.getMessage());
        }
        selector.wakeup();
        join();
    }

    private TcpPort start() {
        wiring.faults().attach(selector::wakeup, this::cutAll);
        thread.start();
        return this;
    }

    private void join() {
        try {
            thread.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void serve() {
        try (Selector open = selector) {
            while (server.isOpen()) {
                lines.forEach(this::setInterest);
                open.select();
                readAndWrite();
                endThoseThatAreOver();
                acceptAll();
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "the lab''s port {0} is lost: {1}", thread.getName(), e.getMessage());
        } finally {
            lines.forEach(line -> end(line, false));
        }
    }

    private void setInterest(TcpLine line) {
        if (line.key().isValid()) {
            int read = wiring.faults().isReading() ? SelectionKey.OP_READ : 0;
            line.key().interestOps(read | (isFlushed(line) ? 0 : SelectionKey.OP_WRITE));
        }
    }

    private boolean isFlushed(TcpLine line) {
        wiring.lock().lock();
        try {
            return line.isFlushed();
        } finally {
            wiring.lock().unlock();
        }
    }

    private void readAndWrite() {
        for (SelectionKey key : selector.selectedKeys()) {
            if (key.attachment() instanceof TcpLine line && key.isValid()) {
                if (key.isWritable()) {
                    locked(line::flush);
                }
                if (key.isReadable()) {
                    read(line);
                }
            }
        }
        selector.selectedKeys().clear();
    }

    private void read(TcpLine line) {
        chunk.clear();
        try {
            int count = line.channel().read(chunk);
            if (count > 0) {
                byte[] bytes = new byte[count];
                chunk.flip().get(bytes);
                line.receive(bytes);
                return;
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "{0} is gone: {1}", line.peer(), e.getMessage());
        }
        line.key().cancel();
        locked(line::peerLeft);
    }

    private void acceptAll() throws IOException {
        if (!server.isOpen()) {
            return;
        }
        if (clients == Clients.ONE) {
            lines.forEach(line -> locked(line::hurryIfPeerLeft));
            endThoseThatAreOver();
        }
        for (SocketChannel channel = server.accept(); channel != null; channel = server.accept()) {
            if (clients == Clients.ONE && !lines.isEmpty()) {
                LOG.log(Level.DEBUG, "a second client of {0} is turned away", address());
                channel.close();
            } else {
                tryToWelcome(channel);
            }
        }
    }

    private void tryToWelcome(SocketChannel channel) throws IOException {
        try {
            welcome(channel);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a client of {0} left before it was greeted: {1}", address(), e.getMessage());
            channel.close();
        }
    }

    private void welcome(SocketChannel channel) throws IOException {
        channel.configureBlocking(false);
        SelectionKey key = channel.register(selector, 0);
        TcpLine line = new TcpLine(channel, key, wiring);
        key.attach(line);
        locked(() -> {
            wiring.firmware().connected(line);
            lines.add(line);
        });
    }

    private void endThoseThatAreOver() {
        List<TcpLine> over = new ArrayList<>();
        locked(() -> lines.stream().filter(RobotLine::isOver).forEach(over::add));
        over.forEach(line -> end(line, false));
    }

    /** Closes a line and says so to the firmware, once. */
    private void end(TcpLine line, boolean abruptly) {
        locked(() -> {
            if (lines.contains(line)) {
                line.cut();
                line.shut(abruptly);
                lines.remove(line);
                wiring.firmware().disconnected(line);
            }
        });
    }

    private void cutAll() {
        lines.forEach(line -> end(line, true));
        selector.wakeup();
    }

    private void locked(Runnable work) {
        wiring.lock().lock();
        try {
            work.run();
        } finally {
            wiring.lock().unlock();
        }
    }
}

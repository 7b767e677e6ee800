package majicsim.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * What the thread of a TCP port does: accept, read, write what a socket did not take at once, and end lines. It alone
 * opens, reads and closes sockets, and it takes the lab's lock for every call of the firmware.
 */
final class TcpService implements Runnable {
    private static final System.Logger LOG = System.getLogger(TcpService.class.getName());

    private final Selector selector;
    private final TcpListener listener;
    private final Clients clients;
    private final Wiring wiring;
    private final List<TcpLine> lines = new CopyOnWriteArrayList<>();
    private final ByteBuffer chunk = ByteBuffer.allocate(4096);
    private volatile boolean ended;

    TcpService(Selector selector, TcpListener listener, Clients clients, Wiring wiring) {
        this.selector = selector;
        this.listener = listener;
        this.clients = clients;
        this.wiring = wiring;
        wiring.faults().attach(this::wakeup, this::cutAll);
        wiring.faults().attachListener(this::awaitListening);
    }

    void step(long labNanos) {
        wiring.tick(labNanos);
        for (int i = 0; i < lines.size(); i++) {
            TcpLine line = lines.get(i);
            line.release();
            if (line.isOver()) {
                wakeup();
            }
        }
    }

    List<LineCount> counts() {
        List<LineCount> counts = new ArrayList<>();
        for (TcpLine line : lines) {
            counts.add(line.count());
        }
        return counts;
    }

    void wakeup() {
        selector.wakeup();
    }

    /** Ends the thread, which closes everything. */
    void end() {
        ended = true;
        wakeup();
    }

    private void awaitListening() {
        if (!ended) {
            wakeup();
            listener.awaitListening(wiring.faults().isReachable());
        }
    }

    @Override
    public void run() {
        try (Selector open = selector) {
            while (!ended) {
                listener.listen(wiring.faults().isReachable());
                lines.forEach(this::setInterest);
                open.select();
                readAndWrite();
                endThoseThatAreOver();
                acceptAll();
            }
            listener.close();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "a port of the lab is lost: {0}", e.getMessage());
        } finally {
            lines.forEach(this::end);
        }
    }

    private void setInterest(TcpLine line) {
        if (line.key().isValid()) {
            line.setInterest(wiring.faults().isReading());
        }
    }

    private void readAndWrite() {
        for (SelectionKey key : selector.selectedKeys()) {
            if (key.attachment() instanceof TcpLine line) {
                if (key.isWritable()) {
                    wiring.locked(line::flush);
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
            }
            if (count >= 0) {
                return;
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "{0} is gone: {1}", line.peer(), e.getMessage());
        }
        line.key().cancel();
        wiring.locked(line::clientLeft);
    }

    /** Takes the lab's lock only for lines that have ended: a line that ends later wakes this thread again. */
    private void endThoseThatAreOver() {
        for (TcpLine line : lines) {
            if (!line.isOpen()) {
                wiring.locked(() -> endIfOver(line));
            }
        }
    }

    private void endIfOver(TcpLine line) {
        if (line.isOver()) {
            end(line);
        }
    }

    private void end(TcpLine line) {
        wiring.locked(() -> {
            line.shut(line.isCut());
            line.cut();
            lines.remove(line);
            wiring.firmware().disconnected(line);
        });
    }

    private void acceptAll() throws IOException {
        makePlace();
        for (SocketChannel channel = listener.accept(); channel != null; channel = listener.accept()) {
            if (!wiring.faults().isReachable()) {
                channel.close();
            } else if (isTaken()) {
                LOG.log(Level.INFO, "a second client is turned away: {0}", channel.getRemoteAddress());
                channel.close();
            } else {
                tryToWelcome(channel);
            }
        }
    }

    /** A client may have disconnected since its line was last read; it must not block the next client. */
    private boolean isTaken() {
        if (clients == Clients.ONE && wiring.faults().isReading()) {
            lines.stream().filter(line -> line.key().isValid()).forEach(this::read);
            makePlace();
        }
        return clients == Clients.ONE && !lines.isEmpty();
    }

    private void makePlace() {
        if (clients == Clients.ONE) {
            lines.forEach(line -> wiring.locked(line::deliverAllIfClientLeft));
            endThoseThatAreOver();
        }
    }

    private void tryToWelcome(SocketChannel channel) throws IOException {
        try {
            welcome(channel);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a client left before it was greeted: {0}", e.getMessage());
            channel.close();
        }
    }

    /** The line is counted only once the firmware has greeted it, so a clock never sees it idle too early. */
    private void welcome(SocketChannel channel) throws IOException {
        channel.configureBlocking(false);
        SelectionKey key = channel.register(selector, 0);
        TcpLine line = new TcpLine(channel, key, wiring);
        key.attach(line);
        wiring.locked(() -> {
            wiring.firmware().connected(line);
            lines.add(line);
        });
    }

    private void cutAll() {
        wiring.locked(() -> lines.forEach(RobotLine::cut));
        wakeup();
    }
}

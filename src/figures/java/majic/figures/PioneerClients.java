package majic.figures;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.List;
import java.util.Objects;
import majicsim.pioneer.packet.PacketWriter;

/**
 * The plainest clients that a Pioneer can have, all on one thread: they shake hands, open the session, read the reports
 * and send a PULSE each second.
 */
final class PioneerClients implements AutoCloseable {
    private static final int OPEN = 1;
    private static final int ENABLE = 4;
    private static final int VEL = 11;
    private static final int RVEL = 21;
    private static final int INTEGER = 0x3B;
    private static final int CIRCLE_MM_PER_SEC = 100;
    private static final int CIRCLE_DEG_PER_SEC = 30;
    private static final int SYNCS = 3;
    private static final byte[] PULSE = new PacketWriter(0).toBytes();
    private static final long PULSE_NANOS = 1_000_000_000;
    private static final int LOOK_MS = 100;

    private final Selector selector = Selector.open();
    private final Thread thread = new Thread(this::serve, "pioneer clients");
    private final ByteBuffer received = ByteBuffer.allocate(1 << 16);
    private volatile boolean closed;
    private volatile long reads;
    private final long beganNanos = System.nanoTime();

    private PioneerClients() throws IOException {}

    /** Connects one client to each address, given as pioneer://host:port. */
    static PioneerClients connect(List<String> addresses) throws IOException {
        PioneerClients clients = new PioneerClients();
        for (String address : addresses) {
            String server = address.substring(address.indexOf("//") + 2);
            int colon = server.lastIndexOf(':');
            clients.add(
                    new InetSocketAddress(server.substring(0, colon), Integer.parseInt(server.substring(colon + 1))));
        }
        clients.thread.setDaemon(true);
        clients.thread.start();
        return clients;
    }

    /** Returns how many messages each client received a second since it was connected. */
    double reportsPerSecond() {
        return reads * 1e9 / (System.nanoTime() - beganNanos) / selector.keys().size();
    }

    /** Lets all robots drive in small circles from now on. */
    void drive() throws IOException {
        for (SelectionKey key : selector.keys()) {
            Client client = Objects.requireNonNull((Client) key.attachment());
            send(client.channel, ENABLE, 1);
            send(client.channel, VEL, CIRCLE_MM_PER_SEC);
            send(client.channel, RVEL, CIRCLE_DEG_PER_SEC);
        }
    }

    @Override
    public void close() throws IOException {
        closed = true;
        selector.wakeup();
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        for (SelectionKey key : selector.keys()) {
            key.channel().close();
        }
        selector.close();
    }

    private void add(InetSocketAddress address) throws IOException {
        SocketChannel channel = SocketChannel.open(address);
        channel.configureBlocking(false);
        channel.register(selector, SelectionKey.OP_READ, new Client(channel));
        send(channel, 0);
    }

    private void serve() {
        long pulseDue = System.nanoTime();
        try {
            while (!closed) {
                selector.select(LOOK_MS);
                for (SelectionKey key : selector.selectedKeys()) {
                    ((Client) key.attachment()).read();
                }
                selector.selectedKeys().clear();
                if (System.nanoTime() >= pulseDue) {
                    pulseDue += PULSE_NANOS;
                    pulse();
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException("a simulated Pioneer has left its client", e);
        }
    }

    private void pulse() throws IOException {
        for (SelectionKey key : selector.keys()) {
            Client client = Objects.requireNonNull((Client) key.attachment());
            if (client.isOpen()) {
                client.channel.write(ByteBuffer.wrap(PULSE));
            }
        }
    }

    private static void send(SocketChannel channel, int id) throws IOException {
        channel.write(ByteBuffer.wrap(new PacketWriter(id).toBytes()));
    }

    private static void send(SocketChannel channel, int id, int argument) throws IOException {
        channel.write(ByteBuffer.wrap(
                new PacketWriter(id).uint8(INTEGER).uint16(argument).toBytes()));
    }

    /** One connection, which counts the answers to its handshake. */
    private final class Client {
        private final SocketChannel channel;
        private int answers;

        Client(SocketChannel channel) {
            this.channel = channel;
        }

        boolean isOpen() {
            return answers >= SYNCS;
        }

        void read() throws IOException {
            received.clear();
            if (channel.read(received) < 0) {
                throw new IOException("end of the connection");
            }
            reads++;
            if (!isOpen()) {
                answers++;
                send(channel, isOpen() ? OPEN : answers);
            }
        }
    }
}

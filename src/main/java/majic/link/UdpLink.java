package majic.link;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * Datagrams (UDP) to and from peers on one socket of this computer. A peer is learned by its datagrams: the owner of
 * the link passes those to {@link #addPeer} that it knows as robots, and only these are sent to. Each write is one
 * datagram to each peer, each read one datagram, whose sender {@link #sender} returns. A datagram that is lost is not
 * noticed here.
 */
public final class UdpLink implements Link {
    private static final Logger LOG = System.getLogger(UdpLink.class.getName());

    /** More peers than robots of a team. */
    private static final int MOST_PEERS = 256;

    private final String host;
    private final int port;
    private final TrafficCounter counter = new TrafficCounter();
    private final ReentrantLock writing = new ReentrantLock();
    private final CopyOnWriteArrayList<InetSocketAddress> peers = new CopyOnWriteArrayList<>();
    private volatile @Nullable DatagramSocket socket;
    private volatile @Nullable InetSocketAddress sender;
    private volatile String local = "";
    private boolean closed;

    /**
     * Creates a link, without opening it.
     *
     * @param host the peer, which is sent to before it has sent anything; empty to wait for peers
     * @param port the peer's port; without a host, the port of this computer to which peers send
     */
    public UdpLink(String host, int port) {
        this.host = host;
        this.port = port;
    }

    @Override
    public void open(int timeoutMs) throws IOException {
        if (!host.isEmpty()) {
            InetAddress computer = new TcpConnector(host, port).find(timeoutMs);
            peers.add(new InetSocketAddress(computer, port));
        }
        DatagramSocket opening = bind();
        synchronized (this) {
            if (closed) {
                opening.close();
                throw new IOException("closed while connecting");
            }
            socket = opening;
        }
        local = name((InetSocketAddress) opening.getLocalSocketAddress());
        counter.opened();
        Links.register(this);
    }

    private DatagramSocket bind() throws IOException {
        try {
            return new DatagramSocket(host.isEmpty() ? port : 0);
        } catch (BindException e) {
            throw new IOException(
                    "the UDP port " + port + " of this computer is used by another program, such as a ground station",
                    e);
        } catch (SocketException e) {
            throw new IOException("the UDP port " + port + " of this computer cannot be opened: " + e.getMessage(), e);
        }
    }

    @Override
    public int read(byte[] buffer) throws IOException {
        counter.readerIsBack();
        DatagramSocket open = socket;
        DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
        try {
            while (open != null) {
                packet.setLength(buffer.length);
                open.receive(packet);
                if (packet.getLength() > 0) {
                    sender = (InetSocketAddress) packet.getSocketAddress();
                    counter.handedOut(packet.getLength());
                    return packet.getLength();
                }
            }
        } catch (IOException e) {
            counter.readerAtEnd();
            if (socket == null) {
                return -1;
            }
            throw e;
        }
        counter.readerAtEnd();
        return -1;
    }

    /**
     * Returns where the newest datagram came from. For the reader thread.
     *
     * @return null before the first datagram
     */
    public @Nullable InetSocketAddress sender() {
        return sender;
    }

    /**
     * Adds a peer, to which {@link #write(byte[])} sends from now on. Does nothing for one that is known already, or
     * when there are 256.
     *
     * @param peer its address
     */
    public void addPeer(InetSocketAddress peer) {
        if (peers.size() < MOST_PEERS) {
            peers.addIfAbsent(peer);
        }
    }

    /** Sends one datagram to each peer; nothing before the first peer. */
    @Override
    public void write(byte[] message) throws IOException {
        send(message, peers);
    }

    /**
     * Sends one datagram to one peer.
     *
     * @param message all of it
     * @param peer where to
     * @throws IOException as of {@link Link#write}
     */
    public void write(byte[] message, InetSocketAddress peer) throws IOException {
        send(message, List.of(peer));
    }

    private void send(byte[] message, List<InetSocketAddress> to) throws IOException {
        DatagramSocket open = socket;
        if (open == null) {
            throw new IOException("the connection is closed");
        }
        WriteDeadline.write(this, writing, "the UDP port " + port, () -> {
            for (InetSocketAddress peer : to) {
                counter.writing(message.length);
                sendOne(open, message, peer);
            }
        });
    }

    /** A peer that cannot be reached, perhaps just now, does not end the link of the others: the datagram is lost. */
    private static void sendOne(DatagramSocket open, byte[] message, InetSocketAddress peer) throws IOException {
        try {
            open.send(new DatagramPacket(message, message.length, peer));
        } catch (IOException | IllegalArgumentException e) {
            if (open.isClosed()) {
                throw new IOException("the connection is closed", e);
            }
            LOG.log(Level.DEBUG, "a datagram to " + name(peer) + " was not sent", e);
        }
    }

    @Override
    public void close() {
        DatagramSocket open;
        synchronized (this) {
            open = socket;
            socket = null;
            closed = true;
        }
        if (open != null) {
            counter.closed();
            Links.tidy();
            open.close();
        }
    }

    @Override
    public void abort() {
        close();
    }

    @Override
    public String address() {
        return "udp:" + host + ":" + port;
    }

    @Override
    public Traffic traffic() {
        return counter.traffic(local, peers.isEmpty() ? "" : name(peers.get(0)));
    }

    private static String name(InetSocketAddress address) {
        return address.getAddress().getHostAddress() + ":" + address.getPort();
    }
}

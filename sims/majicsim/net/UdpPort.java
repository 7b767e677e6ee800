package majicsim.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.util.List;

/**
 * A socket from which a firmware sends datagrams to a peer on this computer, whether or not the peer is there, and
 * receives those that the peer sends back. Its one line is open as long as the port. One daemon thread reads.
 */
public final class UdpPort implements Port {
    private static final System.Logger LOG = System.getLogger(UdpPort.class.getName());
    private static final int LARGEST = 65_536;
    private static final int LOOK_MS = 500;
    private static final int JOIN_MS = 1000;

    private final DatagramChannel channel;
    private final InetSocketAddress peer;
    private final InetSocketAddress own;
    private final Wiring wiring;
    private final UdpLine line;
    private final Thread thread;
    private volatile boolean open = true;

    private UdpPort(DatagramChannel channel, InetSocketAddress peer, Wiring wiring) throws IOException {
        this.channel = channel;
        this.peer = peer;
        this.own = (InetSocketAddress) channel.getLocalAddress();
        this.wiring = wiring;
        this.line = new UdpLine(channel, peer, wiring);
        this.thread = new Thread(this::serve, "lab-udp-" + own.getPort());
        thread.setDaemon(true);
    }

    /**
     * Opens a socket and connects the firmware to it.
     *
     * @param peerPort where the peer listens on loopback, 1 to 65535
     * @param wiring lock, firmware and faults
     * @return the open port
     * @throws IOException if there is no socket
     */
    public static UdpPort open(int peerPort, Wiring wiring) throws IOException {
        InetAddress loopback = InetAddress.getLoopbackAddress();
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.bind(new InetSocketAddress(loopback, 0));
            return new UdpPort(channel, new InetSocketAddress(loopback, peerPort), wiring).start();
        } catch (IOException e) {
            channel.close();
            throw e;
        }
    }

    private UdpPort start() {
        wiring.locked(() -> wiring.firmware().connected(line));
        wiring.faults().attach(() -> {}, () -> wiring.locked(line::discardPending));
        thread.start();
        return this;
    }

    /** Where its datagrams come from. */
    @Override
    public String address() {
        return TcpLine.keyOf(own);
    }

    @Override
    public String suffix() {
        return "-udp";
    }

    @Override
    public void step(long labNanos) {
        wiring.tick(labNanos);
        line.release();
    }

    @Override
    public List<LineCount> lines() {
        return open ? List.of(line.count()) : List.of();
    }

    private void serve() {
        ByteBuffer datagram = ByteBuffer.allocate(LARGEST);
        try {
            while (open) {
                receive(datagram.clear());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (ClosedChannelException e) {
            LOG.log(Level.DEBUG, "{0} is closed", address());
        } catch (IOException e) {
            LOG.log(Level.WARNING, "a port of the lab is lost: {0}", e.getMessage());
        } finally {
            open = false;
            wiring.locked(() -> {
                line.cut();
                wiring.firmware().disconnected(line);
            });
        }
    }

    private void receive(ByteBuffer datagram) throws IOException, InterruptedException {
        wiring.faults().awaitReading(LOOK_MS);
        if (!wiring.faults().isReading()) {
            return;
        }
        SocketAddress from = channel.receive(datagram);
        byte[] bytes = new byte[datagram.flip().remaining()];
        datagram.get(bytes);
        if (open && peer.equals(from) && bytes.length > 0) {
            line.receive(bytes);
        }
    }

    @Override
    public void close() {
        open = false;
        try {
            channel.close();
            thread.join(JOIN_MS);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing {0}: {1}", address(), e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

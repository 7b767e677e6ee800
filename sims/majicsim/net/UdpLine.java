package majicsim.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;

/** The one line of a port for datagrams. Every piece that is written is a datagram. */
final class UdpLine extends RobotLine {
    private static final System.Logger LOG = System.getLogger(UdpLine.class.getName());

    private final DatagramChannel channel;
    private final InetSocketAddress peer;
    private final Faults faults;

    UdpLine(DatagramChannel channel, InetSocketAddress peer, Wiring wiring) throws IOException {
        super(TcpLine.keyOf((InetSocketAddress) channel.getLocalAddress()), TcpLine.keyOf(peer), wiring, true);
        this.channel = channel;
        this.peer = peer;
        this.faults = wiring.faults();
    }

    @Override
    int write(byte[] bytes) {
        if (faults.drawLoss()) {
            return 0;
        }
        try {
            return channel.send(ByteBuffer.wrap(bytes), peer);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a datagram to {0} is lost: {1}", peer(), e.getMessage());
            return 0;
        }
    }

    @Override
    boolean losesArrival() {
        return faults.drawLoss();
    }

    @Override
    boolean isFlushed() {
        return true;
    }

    /** There is no connection that could be closed. */
    @Override
    public void close() {}
}

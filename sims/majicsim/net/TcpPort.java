package majicsim.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.util.List;

/** A TCP port on loopback behind which a firmware listens; served by one daemon thread. */
public final class TcpPort implements Port {
    private static final System.Logger LOG = System.getLogger(TcpPort.class.getName());
    private static final int JOIN_MS = 1000;

    private final ServerSocketChannel server;
    private final TcpService service;
    private final Thread thread;

    private TcpPort(ServerSocketChannel server, TcpService service) {
        this.server = server;
        this.service = service;
        this.thread = new Thread(service, "lab-port-" + server.socket().getLocalPort());
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
            TcpPort opened = new TcpPort(server, new TcpService(server, clients, wiring));
            opened.thread.start();
            return opened;
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
        service.step(labNanos);
    }

    @Override
    public List<LineCount> lines() {
        return service.counts();
    }

    @Override
    public void close() {
        try {
            server.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing {0}: {1}", thread.getName(), e.getMessage());
        }
        service.wakeup();
        try {
            thread.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

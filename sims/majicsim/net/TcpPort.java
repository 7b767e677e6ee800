package majicsim.net;

import java.io.IOException;
import java.nio.channels.Selector;
import java.util.List;

/** A TCP port on loopback behind which a firmware listens; served by one daemon thread. */
public final class TcpPort implements Port {
    private static final int JOIN_MS = 1000;

    private final int number;
    private final TcpService service;
    private final Thread thread;

    private TcpPort(int number, TcpService service) {
        this.number = number;
        this.service = service;
        this.thread = new Thread(service, "lab-port-" + number);
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
        Selector selector = Selector.open();
        try {
            TcpListener listener = TcpListener.open(port, selector);
            TcpPort opened = new TcpPort(listener.port(), new TcpService(selector, listener, clients, wiring));
            opened.thread.start();
            return opened;
        } catch (IOException e) {
            selector.close();
            throw e;
        }
    }

    /**
     * Its number.
     *
     * @return 1 to 65535
     */
    public int number() {
        return number;
    }

    @Override
    public String address() {
        return "127.0.0.1:" + number;
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
        service.end();
        try {
            thread.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

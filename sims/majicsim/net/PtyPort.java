package majicsim.net;

import com.sun.jna.LastErrorException;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;

/**
 * A pseudo-terminal behind which a firmware listens, for clients that want a serial port. Its one line is there as long
 * as the port, whether or not a client has the device open; a cut fault loses what is under way. One daemon thread
 * reads.
 */
public final class PtyPort implements Port {
    private static final System.Logger LOG = System.getLogger(PtyPort.class.getName());
    private static final byte[] NOTHING = {};
    private static final int LOOK_MS = 500;
    private static final int JOIN_MS = 1000;

    private final PseudoTerminal terminal;
    private final Wiring wiring;
    private final PtyLine line;
    private final Thread thread;
    private volatile boolean open = true;
    private boolean closed;

    private PtyPort(PseudoTerminal terminal, Wiring wiring) {
        this.terminal = terminal;
        this.wiring = wiring;
        this.line = new PtyLine(terminal, wiring);
        this.thread = new Thread(this::serve, "lab-pty-" + terminal.path());
        thread.setDaemon(true);
    }

    /**
     * Opens a pseudo-terminal and begins to serve it.
     *
     * @param wiring lock, firmware and faults
     * @return the port; empty where the system has no pseudo-terminals or none is left
     */
    public static Optional<PtyPort> open(Wiring wiring) {
        try {
            return Optional.of(new PtyPort(PseudoTerminal.open(), wiring).start());
        } catch (LastErrorException | LinkageError e) {
            LOG.log(Level.DEBUG, "no pseudo-terminal here: {0}", e.getMessage());
            return Optional.empty();
        }
    }

    @Override
    public String address() {
        return terminal.path();
    }

    @Override
    public String suffix() {
        return "-pty";
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

    @Override
    public synchronized void close() {
        if (closed) {
            return;
        }
        closed = true;
        open = false;
        terminal.wake();
        try {
            thread.join(JOIN_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (!thread.isAlive()) {
            wiring.locked(terminal::close);
        }
    }

    private PtyPort start() {
        wiring.locked(() -> wiring.firmware().connected(line));
        wiring.faults().attach(() -> {}, () -> wiring.locked(line::discardPending));
        thread.start();
        return this;
    }

    private void serve() {
        try {
            while (open) {
                listen();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (LastErrorException e) {
            LOG.log(Level.WARNING, "the lab''s pseudo-terminal {0} is lost: {1}", terminal.path(), e.getMessage());
        } finally {
            end();
        }
    }

    private void listen() throws InterruptedException {
        wiring.faults().awaitReading(LOOK_MS);
        byte[] bytes = wiring.faults().isReading() ? terminal.read(LOOK_MS) : NOTHING;
        if (bytes.length > 0 && open) {
            line.receive(bytes);
        }
    }

    private void end() {
        open = false;
        wiring.locked(() -> {
            line.cut();
            wiring.firmware().disconnected(line);
        });
    }
}

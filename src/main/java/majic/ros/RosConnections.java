package majic.ros;

import java.util.List;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.ros.bridge.BridgeAddress;
import majic.ros.bridge.RosBridge;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The connections to the server of one robot: one for sensors and velocities, and in ROS 2 another one for services and
 * actions, because servers up to 2.1.0 handle nothing else of a connection until a call is answered (rosbridge sheet
 * 1). Thread-safe.
 */
final class RosConnections {
    private static final int TIMEOUT_MS = 3000;

    private final BridgeAddress address;
    private final TimeSource time;
    private final RosBridge.Listener listener;
    private @Nullable RosBridge drive;
    private @Nullable RosBridge services;
    private boolean closed;

    RosConnections(BridgeAddress address, TimeSource time, RosBridge.Listener listener) {
        this.address = address;
        this.time = time;
        this.listener = listener;
    }

    /**
     * Opens the first connection.
     *
     * @throws ConnectFailed if there is no server
     */
    RosBridge open() {
        RosBridge opened = RosBridge.open(address, TIMEOUT_MS, time, listener);
        synchronized (this) {
            drive = opened;
            services = opened;
        }
        endIfClosed(opened);
        return opened;
    }

    /** Opens the second connection. */
    void openServices() {
        RosBridge opened = RosBridge.open(address, TIMEOUT_MS, time, listener);
        synchronized (this) {
            services = opened;
        }
        endIfClosed(opened);
    }

    /**
     * Opens a connection beside these two, which its user has to close. Its end does not end the session.
     *
     * @throws ConnectFailed if the server does not accept it
     */
    RosBridge openFurther() {
        RosBridge opened = RosBridge.open(address, TIMEOUT_MS, time, new Further());
        endIfClosed(opened);
        return opened;
    }

    /** Passes on what concerns the user; what is lost with the connection is reported to its user anyway. */
    private final class Further implements RosBridge.Listener {
        @Override
        public void lost(RosBridge bridge, LinkLost cause) {}

        @Override
        public void notice(String message) {
            listener.notice(message);
        }
    }

    private void endIfClosed(RosBridge opened) {
        boolean over;
        synchronized (this) {
            over = closed;
        }
        if (over) {
            opened.abort();
            throw new BotException("closed while connecting");
        }
    }

    /** The connection for sensors and velocities. */
    synchronized RosBridge drive() {
        return present(drive);
    }

    /** The connection for services and actions. */
    synchronized RosBridge services() {
        return present(services);
    }

    private static RosBridge present(@Nullable RosBridge bridge) {
        if (bridge == null) {
            throw new BotException("not connected");
        }
        return bridge;
    }

    /** Returns the connections, each once; none before the first was opened. */
    synchronized List<RosBridge> all() {
        if (drive == null || services == null) {
            return List.of();
        }
        return drive == services ? List.of(drive) : List.of(drive, services);
    }

    /** Returns whether one of the connections is open. */
    boolean isOpen() {
        return all().stream().anyMatch(RosBridge::isOpen);
    }

    /** Ends all connections in order, and one that is being opened. */
    void close(double seconds) {
        end();
        all().forEach(bridge -> bridge.close(seconds));
    }

    /** Cuts all connections. */
    void abort() {
        end();
        all().forEach(RosBridge::abort);
    }

    private synchronized void end() {
        closed = true;
    }
}

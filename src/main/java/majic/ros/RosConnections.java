package majic.ros;

import java.util.List;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.ros.bridge.BridgeAddress;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.TopicActivity;
import majic.ros.readings.BridgeClient;
import majic.ros.readings.TopicSource;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * The connections to the server of one robot: one for velocities, odometry and contacts; in ROS 2 another one for
 * services and actions, because servers up to 2.1.0 handle nothing else of a connection until a call is answered
 * (rosbridge sheet 1); one for sensors, and one for what may be large, both of which delay neither odometry nor stop.
 * The loss of one of the first two is that of the robot. Thread-safe.
 */
final class RosConnections implements BridgeClient.Connections {
    private static final int TIMEOUT_MS = 3000;

    private final BridgeAddress address;
    private final TimeSource time;
    private final RosBridge.Listener listener;
    private final SideConnection sensors;
    private final SideConnection large;
    private @Nullable RosBridge drive;
    private @Nullable RosBridge services;
    private boolean closed;

    RosConnections(BridgeAddress address, TimeSource time, RosBridge.Listener listener) {
        this.address = address;
        this.time = time;
        this.listener = listener;
        this.sensors = new SideConnection("ros sensors", time, new SideOpener());
        this.large = new SideConnection("ros large topics", time, new SideOpener());
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
        // The first motion needs the round trip, which is measured by pings.
        opened.ping();
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
    @Override
    public RosBridge openFurther() {
        return openFurther(() -> {});
    }

    private RosBridge openFurther(Runnable lost) {
        RosBridge opened = RosBridge.open(address, TIMEOUT_MS, time, new Further(lost));
        endIfClosed(opened);
        return opened;
    }

    /** Opens what is beside the robot's own connections. */
    private final class SideOpener implements SideConnection.Opener {
        @Override
        public RosBridge open(Runnable lost) {
            return openFurther(lost);
        }

        @Override
        public void notice(String message) {
            listener.notice(message);
        }
    }

    /** Passes on what concerns the user; what is lost with the connection is reported to its user. */
    private final class Further implements RosBridge.Listener {
        private final Runnable lost;

        Further(Runnable lost) {
            this.lost = lost;
        }

        @Override
        public void lost(RosBridge bridge, LinkLost cause) {
            lost.run();
        }

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

    @Override
    public synchronized RosBridge drive() {
        return present(drive);
    }

    @Override
    public synchronized RosBridge services() {
        return present(services);
    }

    @Override
    public TopicSource sensors() {
        return sensors;
    }

    @Override
    public TopicSource large() {
        return large;
    }

    /** Returns the topics that are subscribed to on any connection, in no order. */
    List<TopicActivity> activity() {
        return Stream.concat(all().stream().map(RosBridge::activity), Stream.of(sensors.activity(), large.activity()))
                .flatMap(List::stream)
                .toList();
    }

    private static RosBridge present(@Nullable RosBridge bridge) {
        if (bridge == null) {
            throw new BotException("not connected");
        }
        return bridge;
    }

    /** Returns the robot's own connections, each once; none before the first was opened. */
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
        sensors.close(0);
        large.close(0);
    }

    /** Cuts all connections. */
    void abort() {
        end();
        all().forEach(RosBridge::abort);
        sensors.abort();
        large.abort();
    }

    private synchronized void end() {
        closed = true;
    }
}

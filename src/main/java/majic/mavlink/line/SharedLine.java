package majic.mavlink.line;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import majic.driver.FirstBytes;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.link.UdpLink;
import majic.mavlink.frame.FrameCounts;
import majic.mavlink.frame.MavlinkFrame;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.frame.OutgoingMessage;
import majic.mavlink.message.VehicleHeartbeat;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * One open connection, which all its users share. Thread-safe: a write waits for nothing but the other writes of its
 * link.
 */
final class SharedLine {
    /** Peers whose frames are decoded at most; of UDP anything may arrive. */
    private static final int MOST_PEERS = 256;

    /**
     * A vehicle is sought where its number comes from only when its autopilot has been silent for so long where it was,
     * seconds: less than the silence of a lost one.
     */
    private static final double MOVED_S = 2;

    /** A heartbeat that is older does not show that there is such a vehicle now, seconds. */
    private static final double HEARTBEAT_S = 3;

    private final Link link;
    private final @Nullable UdpLink datagrams;
    private final TimeSource time;
    private final List<FrameListener> listeners = new CopyOnWriteArrayList<>();
    private final Map<Integer, LineVehicle> vehicles = new ConcurrentHashMap<>();
    private final Map<InetSocketAddress, LinePeer> strangers = new LinkedHashMap<>();
    private final List<LinePeer> peers = new CopyOnWriteArrayList<>();
    private final LinePeer onlyPeer = LinePeer.at(null);
    private final FirstBytes firstBytes = new FirstBytes();
    private final Object closing = new Object();
    private @Nullable SharedLine before;
    private volatile @Nullable IOException cause;

    /**
     * A vehicle that has sent a frame: where it is, the version of its heartbeats, and when its autopilot has sent
     * something last; null if it has not.
     */
    private record LineVehicle(
            LinePeer peer,
            int version,
            @Nullable Heard heartbeat,
            @Nullable Long heardNanos) {}

    /** A heartbeat and when it arrived. */
    private record Heard(VehicleHeartbeat value, long atNanos) {}

    private boolean opened;

    /**
     * Creates a connection that is not open yet.
     *
     * @param before the connection whose port it takes over, which is closed first; null for none
     */
    SharedLine(Link link, TimeSource time, @Nullable SharedLine before) {
        this.link = link;
        this.time = time;
        this.before = before;
        this.datagrams = link instanceof UdpLink udp ? udp : null;
        if (datagrams == null) {
            peers.add(onlyPeer);
        }
    }

    /**
     * Opens the link and begins to read, unless another user has; one that opens it at the same time is awaited.
     *
     * @return false if it was open and has ended
     * @throws IOException if it cannot be opened
     */
    synchronized boolean openOnce(int timeoutMs) throws IOException {
        IOException failed = cause;
        if (opened) {
            return failed == null;
        }
        if (failed != null) {
            throw new IOException(failed.getMessage(), failed);
        }
        SharedLine old = before;
        before = null;
        if (old != null) {
            old.close();
        }
        try {
            link.open(timeoutMs);
        } catch (IOException e) {
            cause = e;
            throw e;
        }
        opened = true;
        new LinkReader<>(link, "the other end closed it", new Handler()).start("mavlink " + link.address());
        return true;
    }

    /**
     * Adds a user, which is notified of the end.
     *
     * @return false if the connection has ended; the listener is not added then
     */
    boolean add(FrameListener listener) {
        synchronized (listeners) {
            return cause == null && listeners.add(listener);
        }
    }

    /** The numbers of the vehicles that its users have found. */
    IntStream systems() {
        return listeners.stream().mapToInt(FrameListener::system).filter(system -> system != 0);
    }

    void remove(FrameListener listener) {
        listeners.remove(listener);
    }

    /** Why the connection has ended; null while it is open. */
    @Nullable
    IOException cause() {
        return cause;
    }

    FirstBytes firstBytes() {
        return firstBytes;
    }

    /** The newest heartbeats of the autopilots that are there now, by their systems. */
    Map<Integer, VehicleHeartbeat> autopilots() {
        Map<Integer, VehicleHeartbeat> found = new TreeMap<>();
        vehicles.forEach((system, vehicle) -> {
            Heard heartbeat = vehicle.heartbeat();
            if (heartbeat != null && time.secondsSince(heartbeat.atNanos()) <= HEARTBEAT_S) {
                found.put(system, heartbeat.value());
            }
        });
        return found;
    }

    /** Sends to one vehicle; to all peers if it has sent nothing yet. */
    void send(int system, OutgoingMessage message) throws IOException {
        LineVehicle vehicle = vehicles.get(system);
        if (vehicle == null) {
            sendToAll(message);
        } else {
            send(vehicle.peer(), message, vehicle.version());
        }
    }

    /** Sends once to each peer, in MAVLink 1 only if all its vehicles use that. */
    void sendToAll(OutgoingMessage message) throws IOException {
        if (datagrams != null && peers.isEmpty()) {
            datagrams.write(onlyPeer.encoder().encode(message, 2));
        }
        for (LinePeer peer : peers) {
            send(peer, message, version(peer));
        }
    }

    private int version(LinePeer peer) {
        Collection<LineVehicle> all = vehicles.values();
        List<LineVehicle> here =
                all.stream().filter(vehicle -> vehicle.peer() == peer).toList();
        return !here.isEmpty() && here.stream().allMatch(vehicle -> vehicle.version() == 1) ? 1 : 2;
    }

    private void send(LinePeer peer, OutgoingMessage message, int version) throws IOException {
        byte[] frame = peer.encoder().encode(message, version);
        InetSocketAddress address = peer.address();
        if (datagrams != null && address != null) {
            datagrams.write(frame, address);
        } else {
            link.write(frame);
        }
    }

    /** What has arrived where a vehicle is. */
    FrameCounts counts(int system) {
        LineVehicle vehicle = vehicles.get(system);
        return vehicle == null ? FrameCounts.NONE : vehicle.peer().decoder().counts();
    }

    /** Closes the link; returns when it is closed, on whatever thread that is done. */
    void close() {
        synchronized (closing) {
            link.close();
        }
    }

    /**
     * Takes note of where a vehicle is. Commands must reach its autopilot: a camera or a computer of the vehicle, or
     * another vehicle with the same number, may send from another address.
     *
     * @return whether the frame comes from there
     */
    private boolean take(LinePeer peer, MavlinkFrame frame) {
        LineVehicle known = vehicles.get(frame.system());
        LineVehicle before = known == null || known.peer() == peer ? known : null;
        if (known != null && before == null && !hasMoved(known, frame)) {
            return false;
        }
        int version = before == null ? frame.version() : before.version();
        Heard heartbeat = before == null ? null : before.heartbeat();
        if (frame.type() == MavlinkMessageType.HEARTBEAT && frame.isOfAutopilot()) {
            VehicleHeartbeat newest = VehicleHeartbeat.of(frame.payload());
            if (newest.isOfAutopilot()) {
                heartbeat = new Heard(newest, time.nanos());
                version = frame.version();
            }
        }
        Long heard = frame.isOfAutopilot() ? Long.valueOf(time.nanos()) : before == null ? null : before.heardNanos();
        vehicles.put(frame.system(), new LineVehicle(peer, version, heartbeat, heard));
        return true;
    }

    private boolean hasMoved(LineVehicle known, MavlinkFrame frame) {
        Long heard = known.heardNanos();
        return frame.isOfAutopilot() && (heard == null || time.secondsSince(heard) > MOVED_S);
    }

    private void tellOfTwo(MavlinkFrame ignored, LinePeer from) {
        InetSocketAddress address = from.address();
        if (address != null && ignored.isOfAutopilot() && ignored.type() == MavlinkMessageType.HEARTBEAT) {
            listeners.forEach(listener -> listener.ignored(
                    ignored.system(), address.getAddress().getHostAddress() + " port " + address.getPort()));
        }
    }

    /** Decodes each peer's bytes by themselves. */
    private final class Handler implements LinkHandler<MavlinkFrame> {
        @Override
        public void decode(byte[] bytes, int count, Consumer<MavlinkFrame> messages) {
            firstBytes.received(bytes, count);
            LinePeer peer = peer();
            peer.decoder().decode(bytes, count, frame -> {
                know(peer);
                if (take(peer, frame)) {
                    messages.accept(frame);
                } else {
                    tellOfTwo(frame, peer);
                }
            });
        }

        private LinePeer peer() {
            InetSocketAddress sender = datagrams == null ? null : datagrams.sender();
            if (sender == null) {
                return onlyPeer;
            }
            for (LinePeer peer : peers) {
                if (sender.equals(peer.address())) {
                    return peer;
                }
            }
            if (strangers.size() >= MOST_PEERS) {
                strangers.clear();
            }
            return strangers.computeIfAbsent(sender, LinePeer::at);
        }

        /** What has sent a whole frame is sent to from now on. */
        private void know(LinePeer peer) {
            InetSocketAddress address = peer.address();
            if (datagrams != null && address != null && strangers.remove(address) != null) {
                if (peers.size() >= MOST_PEERS) {
                    peers.remove(0);
                }
                peers.add(peer);
                datagrams.addPeer(address);
            }
        }

        @Override
        public void received(MavlinkFrame frame) {
            listeners.forEach(listener -> listener.received(frame));
        }

        @Override
        public void ended(IOException reason) {
            synchronized (listeners) {
                cause = reason;
            }
            close();
            listeners.forEach(listener -> listener.ended(reason));
        }
    }
}

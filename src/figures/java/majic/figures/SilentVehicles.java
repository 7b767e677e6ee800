package majic.figures;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Rovers behind one UDP socket that send heartbeats, change their modes and record when they do. */
final class SilentVehicles implements AutoCloseable {
    private static final int HEARTBEAT_MS = 1000;
    private static final int LONG_COMMAND = 76;
    private static final int SET_MODE = 176;
    private static final int HEADER = 10;
    private static final int EXTRA_OF_HEARTBEAT = 50;

    private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    private final int port;
    private final int[] modes;
    private final Map<Integer, Long> stopped = new ConcurrentHashMap<>();
    private final Thread thread = new Thread(this::run, "vehicles");

    SilentVehicles(int port, int count) throws IOException {
        this.port = port;
        this.modes = new int[count + 1];
        socket.setSoTimeout(20);
        thread.setDaemon(true);
        thread.start();
    }

    /** Forgets the stops so far. */
    void forget() {
        stopped.clear();
    }

    boolean areAllStopped() {
        return stopped.size() == modes.length - 1;
    }

    /** When the first stop of each has arrived. */
    Collection<Long> arrivals() {
        return List.copyOf(stopped.values());
    }

    private void run() {
        long beatNanos = System.nanoTime();
        byte[] buffer = new byte[2048];
        beat();
        while (!socket.isClosed()) {
            try {
                DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
                socket.receive(packet);
                take(ByteBuffer.wrap(buffer, 0, packet.getLength()).order(ByteOrder.LITTLE_ENDIAN));
            } catch (SocketTimeoutException e) {
                // Nothing has come.
            } catch (IOException e) {
                return;
            }
            if ((System.nanoTime() - beatNanos) / 1e6 > HEARTBEAT_MS) {
                beatNanos = System.nanoTime();
                beat();
            }
        }
    }

    /** Each datagram has one frame of MAVLink 1, as the heartbeats are of that. */
    private void take(ByteBuffer frame) {
        boolean isFirst = (frame.get(0) & 0xFF) == 0xFE;
        int id = frame.get(isFirst ? 5 : 7) & 0xFF;
        int payload = isFirst ? 6 : HEADER;
        if (id != LONG_COMMAND || frame.getShort(payload + 28) != SET_MODE) {
            return;
        }
        int system = frame.get(payload + 30) & 0xFF;
        stopped.putIfAbsent(system, System.nanoTime());
        modes[system] = Math.round(frame.getFloat(payload + 4));
        beat(system);
    }

    private void beat() {
        for (int system = 1; system < modes.length; system++) {
            beat(system);
        }
    }

    private void beat(int system) {
        ByteBuffer frame = ByteBuffer.allocate(17).order(ByteOrder.LITTLE_ENDIAN);
        frame.put((byte) 0xFE)
                .put((byte) 9)
                .put((byte) 0)
                .put((byte) system)
                .put((byte) 1)
                .put((byte) 0);
        frame.putInt(modes[system])
                .put((byte) 10)
                .put((byte) 3)
                .put((byte) 1)
                .put((byte) 4)
                .put((byte) 3);
        int crc = 0xFFFF;
        for (int index = 1; index <= 15; index++) {
            int mixed = ((index < 15 ? frame.get(index) : EXTRA_OF_HEARTBEAT) ^ crc) & 0xFF;
            mixed = (mixed ^ mixed << 4) & 0xFF;
            crc = crc >> 8 ^ mixed << 8 ^ mixed << 3 ^ mixed >> 4;
        }
        frame.putShort((short) crc);
        try {
            socket.send(new DatagramPacket(frame.array(), 17, InetAddress.getLoopbackAddress(), port));
        } catch (IOException e) {
            if (!socket.isClosed()) {
                throw new UncheckedIOException(e);
            }
        }
    }

    @Override
    public void close() {
        socket.close();
    }
}

package majicsim.pioneer.devices;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.function.UnaryOperator;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;
import majicsim.pioneer.packet.PacketWriter;
import org.jspecify.annotations.Nullable;

/**
 * One of the controller's serial ports for accessories: bytes go out at the port's baud rate, and what the device
 * answers waits until the client requests it (ARCOS sheet 6.1, TTY2 and GETAUX). At first a loopback plug is in it.
 */
public final class AuxPort {
    /** The longest packet has 200 bytes, 6 of them around the data (ARCOS sheet 2.2). */
    private static final int MOST_BYTES_A_PACKET = 194;

    private static final int MOST_BYTES_REQUESTED = 200;
    private static final int BUFFER_BYTES = 256;
    private static final int BITS_PER_BYTE = 10;

    private final int packetType;
    private final Setting baud;
    private final Settings settings;
    private final Deque<Byte> outgoing = new ArrayDeque<>();
    private final Deque<Byte> incoming = new ArrayDeque<>();
    private UnaryOperator<byte[]> device = bytes -> bytes;
    private double readyBytes;
    private int requested;

    AuxPort(int packetType, Setting baud, Settings settings) {
        this.packetType = packetType;
        this.baud = baud;
        this.settings = settings;
    }

    /** Connects another device, which receives the bytes of a step and returns its answer, empty if it has none. */
    public void plug(UnaryOperator<byte[]> newDevice) {
        device = newDevice;
    }

    /** TTY: sends these bytes. */
    public void transmit(byte[] bytes) {
        append(bytes, outgoing);
    }

    /** GETAUX: requests so many further bytes; 0 discards the waiting bytes and the requests. */
    public void request(int bytes) {
        if (bytes == 0) {
            incoming.clear();
            requested = 0;
        } else if (bytes > 0) {
            requested = Math.min(MOST_BYTES_REQUESTED, requested + bytes);
        }
    }

    boolean isTransmitting() {
        return !outgoing.isEmpty();
    }

    void step(double seconds) {
        if (outgoing.isEmpty()) {
            readyBytes = 0;
            return;
        }
        readyBytes += seconds * bitsPerSecond() / BITS_PER_BYTE;
        int count = Math.min(outgoing.size(), (int) readyBytes);
        if (count > 0) {
            readyBytes -= count;
            append(device.apply(take(outgoing, count)), incoming);
        }
    }

    /** The requested bytes that have arrived, as a packet; null if there is nothing to send. */
    public byte @Nullable [] nextPacket() {
        int count = Math.min(MOST_BYTES_A_PACKET, Math.min(requested, incoming.size()));
        if (count == 0) {
            return null;
        }
        requested -= count;
        PacketWriter packet = new PacketWriter(packetType);
        for (byte b : take(incoming, count)) {
            packet.uint8(b);
        }
        return packet.toBytes();
    }

    private int bitsPerSecond() {
        return HostBaud.bitsPerSecond(settings.get(baud));
    }

    private static void append(byte[] bytes, Deque<Byte> queue) {
        for (byte b : Arrays.copyOf(bytes, Math.min(bytes.length, BUFFER_BYTES - queue.size()))) {
            queue.add(b);
        }
    }

    private static byte[] take(Deque<Byte> queue, int count) {
        byte[] bytes = new byte[count];
        for (int i = 0; i < count; i++) {
            bytes[i] = queue.remove();
        }
        return bytes;
    }
}

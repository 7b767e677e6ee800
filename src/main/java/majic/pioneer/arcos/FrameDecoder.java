package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Finds packets in a stream of bytes that may come in any pieces and with anything between them (ARCOS sheet 2, 14.1).
 * After a wrong checksum the search continues right after the header, so a packet inside the damaged one is not lost.
 * Has no socket, thread or clock. For one thread, except {@link #counts}.
 */
public final class FrameDecoder {
    /** Type and checksum. */
    private static final int SMALLEST_COUNT = 3;

    private byte[] bytes = new byte[2048];
    private int filled;
    private long packets;
    private long damagedPackets;
    private long skippedBytes;
    private volatile PacketCounts counts = PacketCounts.NONE;

    /** Creates a decoder; one for each link. */
    public FrameDecoder() {}

    /** Takes the first {@code count} bytes of a chunk and passes on every packet that is now complete. */
    public void feed(byte[] chunk, int count, Consumer<Packet> sink) {
        if (filled + count > bytes.length) {
            bytes = Arrays.copyOf(bytes, filled + count);
        }
        System.arraycopy(chunk, 0, bytes, filled, count);
        filled += count;
        scan(0, sink);
    }

    /**
     * Drops a packet whose rest is overdue. Its bytes are searched for whole packets; partial ones among them are
     * dropped too, because they would swallow the valid packets that follow.
     */
    public void dropFragment(Consumer<Packet> sink) {
        while (filled > 0) {
            skippedBytes++;
            scan(1, sink);
        }
    }

    private void scan(int from, Consumer<Packet> sink) {
        int at = header(from);
        while (isWhole(at)) {
            int count = count(at);
            if (isIntact(at, count)) {
                packets++;
                sink.accept(new Packet(bytes[at + 3] & 0xFF, bytes, at + 4, at + count + 1));
                at = header(at + count + 3);
            } else {
                damagedPackets += count < SMALLEST_COUNT ? 0 : 1;
                skippedBytes += 2;
                at = header(at + 2);
            }
        }
        System.arraycopy(bytes, at, bytes, 0, filled - at);
        filled -= at;
        counts = new PacketCounts(packets, damagedPackets, skippedBytes);
    }

    /** The next place where a packet may begin; a last FA may be the first half of a header. */
    private int header(int from) {
        int at = from;
        while (at < filled && !mayBegin(at)) {
            at++;
            skippedBytes++;
        }
        return at;
    }

    private boolean mayBegin(int at) {
        return (bytes[at] & 0xFF) == Packet.HEADER_1 && (at + 1 == filled || (bytes[at + 1] & 0xFF) == Packet.HEADER_2);
    }

    private boolean isWhole(int at) {
        return filled - at >= 3 && (count(at) < SMALLEST_COUNT || filled - at >= count(at) + 3);
    }

    private int count(int at) {
        return bytes[at + 2] & 0xFF;
    }

    private boolean isIntact(int at, int count) {
        if (count < SMALLEST_COUNT) {
            return false;
        }
        int sumAt = at + count + 1;
        int sum = (bytes[sumAt] & 0xFF) << 8 | bytes[sumAt + 1] & 0xFF;
        return Packet.checksum(bytes, at + 3, sumAt) == sum;
    }

    /** The counts so far; from any thread. */
    public PacketCounts counts() {
        return counts;
    }
}

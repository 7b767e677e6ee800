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

    /** Where a packet has the number of bytes behind it, from its header on. */
    private static final int COUNT_AT = 2;

    private byte[] bytes = new byte[2048];
    private int filled;

    /** Counted by the one thread, read by any. */
    private volatile long packets;

    private volatile long damagedPackets;
    private volatile long skippedBytes;

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
        while (filled - at > COUNT_AT) {
            int count = bytes[at + COUNT_AT] & 0xFF;
            int end = at + COUNT_AT + 1 + count;
            if (count >= SMALLEST_COUNT && end > filled) {
                break;
            }
            if (count >= SMALLEST_COUNT && isIntact(at, end)) {
                packets++;
                sink.accept(new Packet(bytes[at + COUNT_AT + 1] & 0xFF, bytes, at + COUNT_AT + 2, end - 2));
                at = header(end);
            } else {
                damagedPackets += count < SMALLEST_COUNT ? 0 : 1;
                skippedBytes += 2;
                at = header(at + 2);
            }
        }
        System.arraycopy(bytes, at, bytes, 0, filled - at);
        filled -= at;
    }

    /** The next place where a packet may begin; a last FA may be the first half of a header. */
    private int header(int from) {
        int at = from;
        while (at < filled
                && ((bytes[at] & 0xFF) != Packet.HEADER_1
                        || at + 1 < filled && (bytes[at + 1] & 0xFF) != Packet.HEADER_2)) {
            at++;
            skippedBytes++;
        }
        return at;
    }

    /** Whether the sum at the end of a packet is that over its type and data. */
    private boolean isIntact(int at, int end) {
        int sum = (bytes[end - 2] & 0xFF) << 8 | bytes[end - 1] & 0xFF;
        return Packet.checksum(bytes, at + COUNT_AT + 1, end - 2) == sum;
    }

    /** The counts so far; from any thread. */
    public PacketCounts counts() {
        return new PacketCounts(packets, damagedPackets, skippedBytes);
    }
}

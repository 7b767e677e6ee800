package majicsim.pioneer.packet;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Finds packets in whatever pieces the bytes arrive (ARCOS sheet 2 and 14.1). Noise is skipped; after a wrong checksum
 * or an impossible count the search goes on right behind the header, so that a good packet inside a damaged one is
 * still found.
 */
public final class PacketReader {
    private static final byte HEADER_1 = (byte) 0xFA;
    private static final byte HEADER_2 = (byte) 0xFB;
    /** Id and checksum: a smaller count cannot be a packet. */
    private static final int SMALLEST_COUNT = 3;

    private byte[] pending = {};
    private long skippedBytes;

    /** Takes the next bytes; returns the packets they complete, oldest first. */
    public List<Packet> feed(byte[] bytes) {
        byte[] all = Arrays.copyOf(pending, pending.length + bytes.length);
        System.arraycopy(bytes, 0, all, pending.length, bytes.length);
        return scan(all, 0);
    }

    /**
     * Discards an incomplete packet; returns the packets found behind its header. The controller does so when the line
     * has been silent in the middle of a packet.
     */
    public List<Packet> giveUpFragment() {
        if (pending.length == 0) {
            return List.of();
        }
        skippedBytes++;
        return scan(pending, 1);
    }

    public boolean hasFragment() {
        return pending.length > 0;
    }

    /** How many bytes were no part of any packet so far. */
    public long skippedBytes() {
        return skippedBytes;
    }

    private List<Packet> scan(byte[] bytes, int start) {
        List<Packet> packets = new ArrayList<>();
        int at = nextHeader(bytes, start);
        while (isComplete(bytes, at)) {
            int count = bytes[at + 2] & 0xFF;
            if (isPacket(bytes, at, count)) {
                packets.add(new Packet(bytes[at + 3] & 0xFF, Arrays.copyOfRange(bytes, at + 4, at + count + 1)));
                at = nextHeader(bytes, at + count + 3);
            } else {
                skippedBytes += 2;
                at = nextHeader(bytes, at + 2);
            }
        }
        pending = Arrays.copyOfRange(bytes, at, bytes.length);
        return packets;
    }

    /** Where the next header starts, or may start with the last byte at hand; the length if nowhere. */
    private int nextHeader(byte[] bytes, int start) {
        int at = start;
        while (at < bytes.length && !(bytes[at] == HEADER_1 && (at + 1 == bytes.length || bytes[at + 1] == HEADER_2))) {
            at++;
            skippedBytes++;
        }
        return at;
    }

    /** Whether the packet at this place is complete. */
    private static boolean isComplete(byte[] bytes, int at) {
        int available = bytes.length - at;
        return available >= 3 && ((bytes[at + 2] & 0xFF) < SMALLEST_COUNT || available >= (bytes[at + 2] & 0xFF) + 3);
    }

    private static boolean isPacket(byte[] bytes, int at, int count) {
        if (count < SMALLEST_COUNT) {
            return false;
        }
        int end = at + count + 1;
        int stated = (bytes[end] & 0xFF) << 8 | bytes[end + 1] & 0xFF;
        return stated == Checksum.of(bytes, at + 3, end);
    }
}

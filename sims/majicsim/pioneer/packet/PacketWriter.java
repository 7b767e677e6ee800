package majicsim.pioneer.packet;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Builds one packet to the client: numbers low byte first, strings ended by NUL, checksum high byte first (ARCOS sheet
 * 2, 3).
 */
public final class PacketWriter {
    private static final int HEADER = 3;
    private static final int CHECKSUM = 2;
    private static final int USUAL_BYTES = 64;

    /** The packet from its first byte, with place for the header. */
    private byte[] packet = new byte[USUAL_BYTES];

    private int end = HEADER;

    public PacketWriter(int type) {
        uint8(type);
    }

    /** Adds the low 8 bits. */
    public PacketWriter uint8(int value) {
        reserve(1);
        packet[end++] = (byte) value;
        return this;
    }

    /** Adds the low 16 bits, which is right for signed values and for counters that wrap. */
    public PacketWriter uint16(int value) {
        return uint8(value).uint8(value >> 8);
    }

    public PacketWriter uint16s(int... values) {
        for (int value : values) {
            uint16(value);
        }
        return this;
    }

    public PacketWriter int32(int value) {
        return uint16(value).uint16(value >> 16);
    }

    public PacketWriter text(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        reserve(bytes.length);
        System.arraycopy(bytes, 0, packet, end, bytes.length);
        end += bytes.length;
        return uint8(0);
    }

    /** The whole packet with header, count and checksum, for one write. */
    public byte[] toBytes() {
        int checksum = Checksum.of(packet, HEADER, end);
        byte[] whole = Arrays.copyOf(packet, end + CHECKSUM);
        whole[0] = (byte) 0xFA;
        whole[1] = (byte) 0xFB;
        whole[2] = (byte) (end - HEADER + CHECKSUM);
        whole[end] = (byte) (checksum >> 8);
        whole[end + 1] = (byte) checksum;
        return whole;
    }

    private void reserve(int bytes) {
        if (end + bytes > packet.length) {
            packet = Arrays.copyOf(packet, 2 * packet.length + bytes);
        }
    }
}

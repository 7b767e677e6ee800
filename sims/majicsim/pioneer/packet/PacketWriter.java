package majicsim.pioneer.packet;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Builds one packet to the client: numbers low byte first, strings ended by NUL, checksum high byte first (ARCOS sheet 2, 3). */
public final class PacketWriter {
    private static final int HEADER = 3;
    private static final int AROUND_CONTENT = HEADER + 2;
    private static final int USUAL_BYTES = 64;

    private final ByteArrayOutputStream body = new ByteArrayOutputStream(USUAL_BYTES);

    public PacketWriter(int type) {
        uint8(type);
    }

    /** Adds the low 8 bits. */
    public PacketWriter uint8(int value) {
        body.write(value);
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
        body.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
        return uint8(0);
    }

    /** The whole packet with header, count and checksum, for one write. */
    public byte[] toBytes() {
        byte[] content = body.toByteArray();
        int checksum = Checksum.of(content, 0, content.length);
        byte[] whole = new byte[content.length + AROUND_CONTENT];
        whole[0] = (byte) 0xFA;
        whole[1] = (byte) 0xFB;
        whole[2] = (byte) (content.length + 2);
        System.arraycopy(content, 0, whole, HEADER, content.length);
        whole[HEADER + content.length] = (byte) (checksum >> 8);
        whole[HEADER + content.length + 1] = (byte) checksum;
        return whole;
    }
}

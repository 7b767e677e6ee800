package majic.pioneer.arcos;

/** Encodes packets for the robot (ARCOS sheet 2, 3). */
public final class FrameEncoder {
    /** The protocol's limit for a whole packet, bytes. */
    private static final int LONGEST = 200;

    private static final int POSITIVE = 0x3B;
    private static final int NEGATIVE = 0x1B;
    private static final int STRING = 0x2B;

    private FrameEncoder() {}

    /** A packet without argument, such as a SYNC (ARCOS sheet 4). */
    public static byte[] bare(int id) {
        return frame(id, new byte[0]);
    }

    /**
     * A packet with a whole number; a negative one is sent as its magnitude after another type byte.
     *
     * @throws IllegalArgumentException if the magnitude does not fit 16 bits
     */
    static byte[] number(int id, int value) {
        if (value < -0xFFFF || value > 0xFFFF) {
            throw new IllegalArgumentException("does not fit 16 bits: " + value);
        }
        int magnitude = Math.abs(value);
        int kind = value < 0 ? NEGATIVE : POSITIVE;
        return frame(id, new byte[] {(byte) kind, (byte) magnitude, (byte) (magnitude >> 8)});
    }

    /** A packet with an argument of two bytes. */
    static byte[] pair(int id, int low, int high) {
        return frame(id, new byte[] {POSITIVE, (byte) low, (byte) high});
    }

    /**
     * A packet with a length byte and that many bytes.
     *
     * @throws IllegalArgumentException if the packet would be longer than 200 bytes
     */
    static byte[] string(int id, byte[] text) {
        byte[] data = new byte[text.length + 2];
        data[0] = STRING;
        data[1] = (byte) text.length;
        System.arraycopy(text, 0, data, 2, text.length);
        return frame(id, data);
    }

    private static byte[] frame(int id, byte[] data) {
        byte[] packet = new byte[data.length + 6];
        if (packet.length > LONGEST) {
            throw new IllegalArgumentException("a packet has at most 200 bytes, not " + packet.length);
        }
        packet[0] = (byte) FrameDecoder.HEADER_1;
        packet[1] = (byte) FrameDecoder.HEADER_2;
        packet[2] = (byte) (data.length + 3);
        packet[3] = (byte) id;
        System.arraycopy(data, 0, packet, 4, data.length);
        int sum = Checksum.of(packet, 3, data.length + 4);
        packet[data.length + 4] = (byte) (sum >> 8);
        packet[data.length + 5] = (byte) sum;
        return packet;
    }
}

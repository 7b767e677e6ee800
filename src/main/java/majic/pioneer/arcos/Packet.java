package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.HexFormat;

/**
 * A packet in either direction: its type, which is the number of a command on the way to the robot, and its data (ARCOS
 * sheet 2, 3). Immutable.
 */
public final class Packet {
    static final int HEADER_1 = 0xFA;
    static final int HEADER_2 = 0xFB;

    /** The protocol's limit for a whole packet that is sent, bytes. */
    private static final int LONGEST = 200;

    /** Header, count, type and checksum, bytes. */
    private static final int FRAME_BYTES = 6;

    private static final int POSITIVE = 0x3B;
    private static final int NEGATIVE = 0x1B;
    private static final int STRING = 0x2B;
    private static final int RESET_FROM = 0xFE;

    final int type;

    /** The bytes after the type; not to be changed. */
    final byte[] data;

    /**
     * Copies the data from a larger buffer.
     *
     * @param type 0 to 255
     * @param buffer what holds the data
     * @param from index of the first byte behind the type
     * @param end index behind the last byte before the checksum
     */
    public Packet(int type, byte[] buffer, int from, int end) {
        this(type, Arrays.copyOfRange(buffer, from, end));
    }

    private Packet(int type, byte[] data) {
        this.type = type;
        this.data = data;
    }

    /** A packet without data, such as a SYNC (ARCOS sheet 4). */
    public static Packet bare(int type) {
        return new Packet(type, new byte[0]);
    }

    /**
     * A packet with a whole number; a negative one is sent as its magnitude after another type byte.
     *
     * @param value of at most 16 bits beside its sign
     */
    static Packet ofNumber(int type, int value) {
        int magnitude = Math.abs(value);
        int sign = value < 0 ? NEGATIVE : POSITIVE;
        return new Packet(type, new byte[] {(byte) sign, (byte) magnitude, (byte) (magnitude >> 8)});
    }

    /** A packet with two bytes in place of a number. */
    static Packet ofTwoBytes(int type, int low, int high) {
        return new Packet(type, new byte[] {POSITIVE, (byte) low, (byte) high});
    }

    /** A packet with a length byte and that many bytes. */
    static Packet ofString(int type, byte[] text) {
        byte[] data = new byte[text.length + 2];
        data[0] = STRING;
        data[1] = (byte) text.length;
        System.arraycopy(text, 0, data, 2, text.length);
        return new Packet(type, data);
    }

    /** The kind of packet: 0x30 to 0x3F a SIP, 0x20 CONFIG, ... (ARCOS sheet 8, 10, 11), or the number of a command. */
    public int type() {
        return type;
    }

    /** The bytes after the type; a copy. */
    public byte[] data() {
        return data.clone();
    }

    /** The number that a command has as its argument; 0 without one. */
    public int number() {
        if (data.length < 3) {
            return 0;
        }
        int magnitude = data[1] & 0xFF | (data[2] & 0xFF) << 8;
        return data[0] == NEGATIVE ? -magnitude : magnitude;
    }

    /** The bytes that a command has as its argument; none without them. */
    public byte[] text() {
        return Arrays.copyOfRange(data, Math.min(2, data.length), data.length);
    }

    /** A fresh cursor at the first data byte. */
    FieldReader fields() {
        return new FieldReader(data);
    }

    /** Whether the controller was reset in the middle of a session; its settings are lost (ARCOS sheet 11.6). */
    public boolean isReset() {
        return type >= RESET_FROM;
    }

    /** Whether it is a standard SIP; ARIA takes all of 0x30 to 0x3F for one (ARCOS sheet 8). */
    public boolean isSip() {
        return (type & 0xF0) == 0x30;
    }

    /**
     * The packet as it is sent, with header, count and checksum.
     *
     * @throws IllegalArgumentException if it is longer than 200 bytes
     */
    public byte[] bytes() {
        byte[] bytes = new byte[data.length + FRAME_BYTES];
        if (bytes.length > LONGEST) {
            throw new IllegalArgumentException("a packet has at most " + LONGEST + " bytes, not " + bytes.length);
        }
        bytes[0] = (byte) HEADER_1;
        bytes[1] = (byte) HEADER_2;
        bytes[2] = (byte) (data.length + 3);
        bytes[3] = (byte) type;
        System.arraycopy(data, 0, bytes, 4, data.length);
        int sum = checksum(bytes, 3, data.length + 4);
        bytes[data.length + 4] = (byte) (sum >> 8);
        bytes[data.length + 5] = (byte) sum;
        return bytes;
    }

    /**
     * The sum over a packet's type and data (ARCOS sheet 2.1): bytes in pairs, the first of each pair high; a last
     * single byte is XORed in.
     *
     * @param from index of the packet's type
     * @param end index behind the last data byte
     */
    static int checksum(byte[] bytes, int from, int end) {
        int sum = 0;
        int at = from;
        for (; at + 1 < end; at += 2) {
            sum += (bytes[at] & 0xFF) << 8 | bytes[at + 1] & 0xFF;
        }
        return (at < end ? sum ^ bytes[at] & 0xFF : sum) & 0xFFFF;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Packet packet && packet.type == type && Arrays.equals(packet.data, data);
    }

    @Override
    public int hashCode() {
        return 31 * type + Arrays.hashCode(data);
    }

    @Override
    public String toString() {
        return HexFormat.of().toHexDigits((byte) type) + " " + HexFormat.of().formatHex(data);
    }
}

package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.HexFormat;

/** A packet with a valid checksum: its type and its data. Immutable. */
public final class Packet {
    private static final int RESET_FROM = 0xFE;

    private final int type;
    private final byte[] data;

    /**
     * Copies the data from a larger buffer.
     *
     * @param type 0 to 255
     * @param buffer what holds the data
     * @param from index of the first byte behind the type
     * @param end index behind the last byte before the checksum
     */
    public Packet(int type, byte[] buffer, int from, int end) {
        this.type = type;
        this.data = Arrays.copyOfRange(buffer, from, end);
    }

    /** The kind of packet: 0x30 to 0x3F a SIP, 0x20 CONFIG, ... (ARCOS sheet 8, 10, 11). */
    public int type() {
        return type;
    }

    /** The bytes after the type; a copy. */
    public byte[] data() {
        return data.clone();
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

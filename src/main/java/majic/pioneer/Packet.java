package majic.pioneer;

import java.util.Arrays;
import java.util.HexFormat;

/** One packet whose checksum was right: its type and its data. Immutable. */
final class Packet {
    private final int type;
    private final byte[] data;

    /** Copies the data from a larger buffer. */
    Packet(int type, byte[] buffer, int from, int end) {
        this.type = type;
        this.data = Arrays.copyOfRange(buffer, from, end);
    }

    int type() {
        return type;
    }

    /** A fresh cursor at the first data byte. */
    Fields fields() {
        return new Fields(data);
    }

    /** Whether it is a standard SIP; ARIA takes all of 0x30 to 0x3F for one (ARCOS sheet 8). */
    boolean isSip() {
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

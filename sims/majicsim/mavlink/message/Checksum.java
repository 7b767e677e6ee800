package majicsim.mavlink.message;

/** The checksum of a frame: X.25 without the final inversion (sheet 2). For one use. */
final class Checksum {
    private int value = 0xFFFF;

    /** Adds a byte, of which the low eight bits count. */
    Checksum add(int octet) {
        value ^= octet & 0xFF;
        for (int bit = 0; bit < 8; bit++) {
            value = (value & 1) == 0 ? value >> 1 : value >> 1 ^ 0x8408;
        }
        return this;
    }

    Checksum add(byte[] bytes, int start, int end) {
        for (int i = start; i < end; i++) {
            add(bytes[i]);
        }
        return this;
    }

    /** The checksum of all bytes added so far, 16 bits. */
    int value() {
        return value;
    }
}

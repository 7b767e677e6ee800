package majicsim.pioneer.packet;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * What stands behind a command's number (ARCOS sheet 3). Every command may come with or without an argument; bytes that
 * are missing count as zero and surplus bytes are ignored, so reading one never fails.
 */
public record Argument(byte[] data) {
    private static final int NEGATIVE = 0x1B;

    /** The number: a magnitude, negative by its type byte; -65535 to 65535. */
    public int integer() {
        return at(0) == NEGATIVE ? -magnitude() : magnitude();
    }

    public boolean isOn() {
        return integer() != 0;
    }

    /** The low byte of the two packed in the 16 bits, signed; right both for a negated magnitude and for raw bytes. */
    public int lowByte() {
        return (byte) integer();
    }

    /** The high byte of the two packed in the 16 bits, signed. */
    public int highByte() {
        return (byte) (integer() >> 8);
    }

    /** Number {@code index} of the 32-bit numbers that some commands have; their type byte means nothing. */
    public int int32(int index) {
        int start = 1 + 4 * index;
        return at(start) | at(start + 1) << 8 | at(start + 2) << 16 | at(start + 3) << 24;
    }

    /** Number {@code index} of several 16-bit numbers behind one type byte, signed. */
    public int int16(int index) {
        return (short) (at(1 + 2 * index) | at(2 + 2 * index) << 8);
    }

    public boolean hasInt16(int index) {
        return data.length >= 3 + 2 * index;
    }

    /** The string, at most to the end of the packet, whatever its length byte says. */
    public String text() {
        return new String(bytes(), StandardCharsets.US_ASCII);
    }

    /** The string's bytes. */
    public byte[] bytes() {
        int length = Math.min(at(1), Math.max(0, data.length - 2));
        return length == 0 ? new byte[0] : Arrays.copyOfRange(data, 2, 2 + length);
    }

    /** The string behind a first 16-bit number, its length in 16 bits too; at most to the end of the packet. */
    public String textBehindNumber() {
        int start = Math.min(data.length, 5);
        int length = Math.min(at(3) | at(4) << 8, data.length - start);
        return new String(data, start, length, StandardCharsets.US_ASCII);
    }

    private int magnitude() {
        return at(1) | at(2) << 8;
    }

    private int at(int index) {
        return index < data.length ? data[index] & 0xFF : 0;
    }
}

package majic.mavlink.frame;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The fields of a message, each at its offset. What the sender has left out is zero. Immutable. */
public final class Payload {
    private final ByteBuffer bytes;

    /**
     * Keeps a copy.
     *
     * @param received as it arrived, perhaps without zeros at its end
     * @param length of the message with all its fields
     */
    public Payload(byte[] received, int length) {
        this.bytes = ByteBuffer.wrap(Arrays.copyOf(received, length)).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Returns an unsigned byte. */
    public int u8(int offset) {
        return bytes.get(offset) & 0xFF;
    }

    /** Returns a signed byte. */
    public int i8(int offset) {
        return bytes.get(offset);
    }

    /** Returns an unsigned number of two bytes. */
    public int u16(int offset) {
        return bytes.getShort(offset) & 0xFFFF;
    }

    /** Returns a signed number of two bytes. */
    public int i16(int offset) {
        return bytes.getShort(offset);
    }

    /** Returns an unsigned number of four bytes. */
    public long u32(int offset) {
        return bytes.getInt(offset) & 0xFFFF_FFFFL;
    }

    /** Returns a signed number of four bytes. */
    public int i32(int offset) {
        return bytes.getInt(offset);
    }

    /** Returns eight bytes as bits. */
    public long bits64(int offset) {
        return bytes.getLong(offset);
    }

    /** Returns a number of four bytes with a point, which may be infinite or NaN. */
    public double f32(int offset) {
        return bytes.getFloat(offset);
    }

    /**
     * Returns a text, which ends at the first zero byte.
     *
     * @param length of its field
     */
    public String text(int offset, int length) {
        int end = offset;
        while (end < offset + length && bytes.get(end) != 0) {
            end++;
        }
        return new String(bytes.array(), offset, end - offset, StandardCharsets.UTF_8);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Payload payload && Arrays.equals(bytes.array(), payload.bytes.array());
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(bytes.array());
    }

    @Override
    public String toString() {
        return Arrays.toString(bytes.array());
    }
}

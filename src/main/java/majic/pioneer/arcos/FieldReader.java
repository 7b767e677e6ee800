package majic.pioneer.arcos;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * Reads a packet's data field by field, low byte first (ARCOS sheet 3). Fields beyond the end read as zero, so a short
 * packet is not an error.
 */
final class FieldReader {
    private final byte[] data;
    private int at;

    FieldReader(byte[] data) {
        this.data = data;
    }

    int remaining() {
        return data.length - at;
    }

    int ubyte() {
        return at < data.length ? data[at++] & 0xFF : 0;
    }

    int sbyte() {
        return (byte) ubyte();
    }

    int uint() {
        return (int) number(2);
    }

    int sint() {
        return (short) number(2);
    }

    long uint32() {
        return number(4);
    }

    int sint32() {
        return (int) number(4);
    }

    /** A number of so many bytes; half a field at the end belongs to no field. */
    private long number(int bytes) {
        int from = at;
        at = Math.min(data.length, at + bytes);
        long value = 0;
        if (from + bytes <= data.length) {
            for (int index = bytes - 1; index >= 0; index--) {
                value = value << 8 | data[from + index] & 0xFF;
            }
        }
        return value;
    }

    /** As many bytes as that, or as there are. */
    List<Integer> ubytes(int count) {
        Integer[] values = new Integer[Math.min(count, data.length - at)];
        for (int index = 0; index < values.length; index++) {
            values[index] = data[at++] & 0xFF;
        }
        return List.of(values);
    }

    /** As many numbers of 16 bits as that, or as there are. */
    List<Integer> uints(int count) {
        Integer[] values = new Integer[Math.min(count, (data.length - at) / 2)];
        for (int index = 0; index < values.length; index++) {
            values[index] = data[at++] & 0xFF | (data[at++] & 0xFF) << 8;
        }
        return List.of(values);
    }

    /** A cursor of its own for the next bytes, which are skipped here; they must be there. */
    FieldReader part(int bytes) {
        at += bytes;
        return new FieldReader(Arrays.copyOfRange(data, at - bytes, at));
    }

    /** Text up to a NUL, which is swallowed, or to the end. */
    String string() {
        int end = at;
        while (end < data.length && data[end] != 0) {
            end++;
        }
        String text = new String(data, at, end - at, StandardCharsets.ISO_8859_1);
        at = Math.min(end + 1, data.length);
        return text;
    }
}

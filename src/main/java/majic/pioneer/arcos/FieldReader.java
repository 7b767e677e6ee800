package majic.pioneer.arcos;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * Reads a packet's data field by field, low byte first (ARCOS sheet 3). Fields beyond the end read as zero or as what
 * the caller names, so a short packet is not an error.
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
        return ubyteOr(0);
    }

    int ubyteOr(int missing) {
        return remaining() >= 1 ? data[at++] & 0xFF : missing(missing);
    }

    int sbyteOr(int missing) {
        return remaining() >= 1 ? data[at++] : missing(missing);
    }

    int uint() {
        return uintOr(0);
    }

    int uintOr(int missing) {
        if (remaining() < 2) {
            return missing(missing);
        }
        at += 2;
        return data[at - 2] & 0xFF | (data[at - 1] & 0xFF) << 8;
    }

    int sint() {
        return (short) uint();
    }

    int sintOr(int missing) {
        return remaining() >= 2 ? sint() : missing(missing);
    }

    long uint32Or(long missing) {
        if (remaining() < 4) {
            missing(0);
            return missing;
        }
        return uint() | (long) uint() << 16;
    }

    int sint32() {
        return (int) uint32Or(0);
    }

    /** As many bytes as that, or as there are. */
    List<Integer> ubytes(int count) {
        Integer[] values = new Integer[Math.min(count, remaining())];
        for (int index = 0; index < values.length; index++) {
            values[index] = ubyte();
        }
        return List.of(values);
    }

    /** As many numbers of 16 bits as that, or as there are. */
    List<Integer> uints(int count) {
        Integer[] values = new Integer[Math.min(count, remaining() / 2)];
        for (int index = 0; index < values.length; index++) {
            values[index] = uint();
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

    /** Half a field at the end belongs to no field. */
    private int missing(int value) {
        at = data.length;
        return value;
    }
}

package majicsim.ros.websocket;

import java.util.Arrays;

/** Received bytes that have not been used yet. Grows with what is put in, and shrinks when all of it has been taken. */
final class ByteBacklog {
    private static final int SMALL = 4096;

    private byte[] bytes = new byte[SMALL];
    private int from;
    private int to;

    void put(byte[] more) {
        if (to + more.length > bytes.length) {
            bytes = Arrays.copyOfRange(bytes, from, from + Math.max(SMALL, 2 * (available() + more.length)));
            to -= from;
            from = 0;
        }
        System.arraycopy(more, 0, bytes, to, more.length);
        to += more.length;
    }

    int available() {
        return to - from;
    }

    /** Returns the byte at this distance from the first one, 0 to 255. */
    int peek(int index) {
        return bytes[from + index] & 0xFF;
    }

    byte[] take(int count) {
        byte[] taken = Arrays.copyOfRange(bytes, from, from + count);
        from += count;
        if (from == to) {
            from = 0;
            to = 0;
            bytes = bytes.length > SMALL ? new byte[SMALL] : bytes;
        }
        return taken;
    }
}

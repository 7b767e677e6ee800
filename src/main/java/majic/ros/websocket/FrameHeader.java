package majic.ros.websocket;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;

/**
 * The header of a frame from a server, which must not be masked (RFC 6455, 5.1 and 5.2). Immutable.
 *
 * @param last whether it is the last frame of its message
 * @param opcode the kind
 * @param length of the content, bytes
 */
record FrameHeader(boolean last, Opcode opcode, long length) {
    /** The longest header of an unmasked frame. */
    static final int MOST_BYTES = 10;

    private static final int FIXED_BYTES = 2;
    private static final int FINAL = 0x80;
    private static final int RESERVED = 0x70;
    private static final int OPCODE = 0x0F;
    private static final int MASKED = 0x80;
    private static final int LENGTH = 0x7F;
    private static final int LENGTH_IN_16_BITS = 126;
    private static final int LENGTH_IN_64_BITS = 127;
    private static final int LONGEST_CONTROL = 125;

    /**
     * Reads a header.
     *
     * @param bytes the beginning of a frame, from index 0 to the position; not changed
     * @return the header; null if it is incomplete
     * @throws IllegalArgumentException if a client has to give up the connection; the message says what is wrong
     */
    static @Nullable FrameHeader read(ByteBuffer bytes) {
        int count = bytes.position();
        if (count < FIXED_BYTES) {
            return null;
        }
        int first = bytes.get(0) & 0xFF;
        int second = bytes.get(1) & 0xFF;
        int lengthBytes = lengthBytes(second & LENGTH);
        if (count < FIXED_BYTES + lengthBytes) {
            return null;
        }
        long length = switch (lengthBytes) {
            case 0 -> second & LENGTH;
            case Short.BYTES -> bytes.getShort(FIXED_BYTES) & 0xFFFF;
            default -> bytes.getLong(FIXED_BYTES);
        };
        return checked(first, second, length);
    }

    private static int lengthBytes(int length) {
        return switch (length) {
            case LENGTH_IN_16_BITS -> Short.BYTES;
            case LENGTH_IN_64_BITS -> Long.BYTES;
            default -> 0;
        };
    }

    private static FrameHeader checked(int first, int second, long length) {
        Opcode opcode = Opcode.of(first & OPCODE);
        boolean last = (first & FINAL) != 0;
        if (opcode == null || (first & RESERVED) != 0) {
            throw new IllegalArgumentException("a frame of an unknown kind");
        }
        if ((second & MASKED) != 0) {
            throw new IllegalArgumentException("a masked frame, which only clients send");
        }
        if (length < 0) {
            throw new IllegalArgumentException("a frame of a negative length");
        }
        if (opcode.isControl() && (!last || length > LONGEST_CONTROL)) {
            throw new IllegalArgumentException("a control frame that is too long");
        }
        return new FrameHeader(last, opcode, length);
    }
}

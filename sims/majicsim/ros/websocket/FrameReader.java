package majicsim.ros.websocket;

import org.jspecify.annotations.Nullable;

/**
 * Takes frames of a client out of the bytes that it sent, however these arrive (RFC 6455, section 5). Knows no line.
 */
final class FrameReader {
    private static final int FINAL = 0x80;
    private static final int RESERVED_BITS = 0x70;
    private static final int OPCODE_BITS = 0x0F;
    private static final int MASKED = 0x80;
    private static final int LENGTH_BITS = 0x7F;
    private static final int LENGTH_OF_TWO_BYTES = 126;
    private static final int LENGTH_OF_EIGHT_BYTES = 127;
    private static final int MOST_IN_CONTROL_FRAMES = 125;
    private static final int MASK_BYTES = 4;

    private final ByteBacklog backlog;
    private final long mostBytes;

    /**
     * Reads from these bytes; a longer payload than {@code mostBytes} is a violation as soon as its length has arrived.
     */
    FrameReader(ByteBacklog backlog, long mostBytes) {
        this.backlog = backlog;
        this.mostBytes = mostBytes;
    }

    /** Returns the next frame; null if it has not arrived completely. */
    @Nullable
    Frame next() throws ProtocolViolation {
        if (backlog.available() < 2) {
            return null;
        }
        int first = backlog.peek(0);
        int second = backlog.peek(1);
        Opcode opcode = checkedOpcode(first);
        int lengthBytes = lengthBytes(second & LENGTH_BITS);
        if (backlog.available() < 2 + lengthBytes) {
            return null;
        }
        long length = checkedLength(opcode, first, second, lengthBytes);
        int headBytes = 2 + lengthBytes + MASK_BYTES;
        if (backlog.available() < headBytes + length) {
            return null;
        }
        byte[] head = backlog.take(headBytes);
        byte[] payload = backlog.take((int) length);
        for (int i = 0; i < payload.length; i++) {
            payload[i] ^= head[headBytes - MASK_BYTES + i % MASK_BYTES];
        }
        return new Frame((first & FINAL) != 0, opcode, payload);
    }

    private static Opcode checkedOpcode(int first) throws ProtocolViolation {
        Opcode opcode = Opcode.of(first & OPCODE_BITS);
        if (opcode == null || (first & RESERVED_BITS) != 0) {
            throw new ProtocolViolation(CloseCode.PROTOCOL_ERROR, "a reserved opcode or bit is set");
        }
        return opcode;
    }

    private static int lengthBytes(int length) {
        return switch (length) {
            case LENGTH_OF_TWO_BYTES -> 2;
            case LENGTH_OF_EIGHT_BYTES -> 8;
            default -> 0;
        };
    }

    private long checkedLength(Opcode opcode, int first, int second, int lengthBytes) throws ProtocolViolation {
        if ((second & MASKED) == 0) {
            throw new ProtocolViolation(CloseCode.PROTOCOL_ERROR, "a client's frame must be masked");
        }
        long length = lengthBytes == 0 ? second & LENGTH_BITS : 0;
        for (int i = 0; i < lengthBytes; i++) {
            length = length << 8 | backlog.peek(2 + i);
        }
        if (opcode.isControl() && (length > MOST_IN_CONTROL_FRAMES || (first & FINAL) == 0)) {
            throw new ProtocolViolation(CloseCode.PROTOCOL_ERROR, "a control frame is too long or not final");
        }
        if (length < 0 || length > mostBytes) {
            throw new ProtocolViolation(CloseCode.TOO_BIG, "a message is too big");
        }
        return length;
    }
}

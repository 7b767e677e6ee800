package majicsim.ros.websocket;

import java.nio.ByteBuffer;

/** Frames of a server: never masked, one a message (RFC 6455, section 5). */
final class FrameWriter {
    private static final int FINAL = 0x80;
    private static final int SHORT = 125;
    private static final int LENGTH_OF_TWO_BYTES = 126;
    private static final int LENGTH_OF_EIGHT_BYTES = 127;
    private static final int LONGEST_HEAD = 10;

    private FrameWriter() {}

    /** Returns the bytes of a whole message. */
    static byte[] message(Opcode opcode, byte[] payload) {
        byte[] head = head(opcode, payload.length);
        return ByteBuffer.allocate(head.length + payload.length)
                .put(head)
                .put(payload)
                .array();
    }

    /** Returns the bytes before the payload of a whole message. */
    static byte[] head(Opcode opcode, long length) {
        ByteBuffer head = ByteBuffer.allocate(LONGEST_HEAD).put((byte) (FINAL | opcode.code()));
        if (length <= SHORT) {
            head.put((byte) length);
        } else if (length <= 0xFFFF) {
            head.put((byte) LENGTH_OF_TWO_BYTES).putShort((short) length);
        } else {
            head.put((byte) LENGTH_OF_EIGHT_BYTES).putLong(length);
        }
        byte[] bytes = new byte[head.position()];
        head.flip().get(bytes);
        return bytes;
    }
}

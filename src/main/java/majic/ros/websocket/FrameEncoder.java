package majic.ros.websocket;

import java.nio.ByteBuffer;
import java.security.SecureRandom;

/**
 * Encodes the frames of a client, which are masked and hold a whole message each (RFC 6455, 5.2 and 5.3). Thread-safe.
 */
final class FrameEncoder {
    private static final int FINAL = 0x80;
    private static final int MASKED = 0x80;
    private static final int MASK_BYTES = 4;
    private static final int SHORT_LENGTH = 125;
    private static final int LENGTH_IN_16_BITS = 126;
    private static final int LENGTH_IN_64_BITS = 127;
    private static final int LONGEST_IN_16_BITS = 0xFFFF;
    private static final int LONGEST_HEADER = 14;

    private final SecureRandom random = new SecureRandom();

    /**
     * Encodes one message.
     *
     * @param content at most 125 bytes for a control frame
     * @return the frame
     */
    byte[] encode(Opcode opcode, byte[] content) {
        byte[] mask = new byte[MASK_BYTES];
        random.nextBytes(mask);
        ByteBuffer frame = ByteBuffer.allocate(LONGEST_HEADER + content.length);
        frame.put((byte) (FINAL | opcode.code()));
        putLength(frame, content.length);
        frame.put(mask);
        for (int i = 0; i < content.length; i++) {
            frame.put((byte) (content[i] ^ mask[i % MASK_BYTES]));
        }
        byte[] bytes = new byte[frame.position()];
        frame.flip().get(bytes);
        return bytes;
    }

    private static void putLength(ByteBuffer frame, int length) {
        if (length <= SHORT_LENGTH) {
            frame.put((byte) (MASKED | length));
        } else if (length <= LONGEST_IN_16_BITS) {
            frame.put((byte) (MASKED | LENGTH_IN_16_BITS)).putShort((short) length);
        } else {
            frame.put((byte) (MASKED | LENGTH_IN_64_BITS)).putLong(length);
        }
    }
}

package majic.ros;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Base64;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The server's end of a WebSocket in tests, written apart from the driver's: the frames of clients, masked. */
public final class ServerFrames {
    public static final int TEXT = 1;
    public static final int CLOSE = 8;
    public static final int PING = 9;
    public static final int PONG = 10;

    private static final Pattern KEY = Pattern.compile("Sec-WebSocket-Key: *(\\S+)", Pattern.CASE_INSENSITIVE);

    private final ByteArrayOutputStream waiting = new ByteArrayOutputStream();
    private boolean upgraded;

    /**
     * Takes in bytes of the client.
     *
     * @param answer receives what has to be sent: the answer to the handshake
     * @param frames receives each whole frame: its opcode and content
     */
    public void receive(byte[] bytes, Consumer<byte[]> answer, BiConsumer<Integer, byte[]> frames) {
        waiting.writeBytes(bytes);
        if (!upgraded) {
            String head = waiting.toString(StandardCharsets.ISO_8859_1);
            int end = head.indexOf("\r\n\r\n");
            if (end < 0) {
                return;
            }
            keepFrom(end + 4);
            upgraded = true;
            answer.accept(acceptance(head));
        }
        while (takeFrame(frames)) {
            // the next one
        }
    }

    private void keepFrom(int start) {
        byte[] all = waiting.toByteArray();
        waiting.reset();
        waiting.write(all, start, all.length - start);
    }

    private static byte[] acceptance(String head) {
        Matcher key = KEY.matcher(head);
        if (!key.find()) {
            throw new AssertionError("no key in " + head);
        }
        try {
            byte[] digest = MessageDigest.getInstance("SHA-1")
                    .digest((key.group(1) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11")
                            .getBytes(StandardCharsets.US_ASCII));
            return ("HTTP/1.1 101 Switching Protocols\r\nServer: test\r\nUpgrade: WebSocket\r\nConnection: Upgrade\r\n"
                            + "Sec-WebSocket-Accept: " + Base64.getEncoder().encodeToString(digest) + "\r\n\r\n")
                    .getBytes(StandardCharsets.US_ASCII);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError(e);
        }
    }

    private boolean takeFrame(BiConsumer<Integer, byte[]> frames) {
        byte[] all = waiting.toByteArray();
        if (all.length < 2) {
            return false;
        }
        int length = all[1] & 0x7F;
        int at = 2;
        if (length == 126) {
            length = all.length < 4
                    ? Integer.MAX_VALUE
                    : ByteBuffer.wrap(all, 2, 2).getShort() & 0xFFFF;
            at = 4;
        } else if (length == 127) {
            length = all.length < 10
                    ? Integer.MAX_VALUE
                    : (int) ByteBuffer.wrap(all, 2, 8).getLong();
            at = 10;
        }
        if (all.length - at - 4 < length) {
            return false;
        }
        if ((all[1] & 0x80) == 0) {
            throw new AssertionError("a client masks its frames");
        }
        byte[] content = Arrays.copyOfRange(all, at + 4, at + 4 + length);
        for (int i = 0; i < length; i++) {
            content[i] ^= all[at + i % 4];
        }
        keepFrom(at + 4 + length);
        frames.accept(all[0] & 0x0F, content);
        return true;
    }

    /** Encodes a frame of the server that is the whole message. */
    public static byte[] frame(int opcode, byte[] content) {
        return frame(0x80 | opcode, content, content.length);
    }

    /** Encodes a text message. */
    public static byte[] text(String text) {
        return frame(TEXT, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Encodes a frame.
     *
     * @param first its first byte
     * @param announced the length in its header
     */
    public static byte[] frame(int first, byte[] content, long announced) {
        ByteBuffer frame = ByteBuffer.allocate(10 + content.length);
        frame.put((byte) first);
        if (announced >= 0 && announced < 126) {
            frame.put((byte) announced);
        } else if (announced >= 0 && announced < 65536) {
            frame.put((byte) 126).putShort((short) announced);
        } else {
            frame.put((byte) 127).putLong(announced);
        }
        frame.put(content);
        return Arrays.copyOf(frame.array(), frame.position());
    }
}

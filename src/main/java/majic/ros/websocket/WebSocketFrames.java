package majic.ros.websocket;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * Decodes the frames of a server to messages. Keeps at most one message of the greatest length, whatever lengths the
 * server announces: the content of a longer message is skipped as it arrives. Used by one thread.
 */
final class WebSocketFrames {
    /** The code of a close frame without one (RFC 6455, 7.1.5). */
    private static final int NO_CODE = 1005;

    private final int mostBytes;
    private final ByteBuffer header = ByteBuffer.allocate(FrameHeader.MOST_BYTES);
    private @Nullable FrameHeader frame;
    private long left;

    /** The content of the message, whose frames control frames may separate; null between messages. */
    private @Nullable ByteArrayOutputStream message;

    private Opcode kind = Opcode.TEXT;
    private boolean tooLong;
    private ByteArrayOutputStream control = new ByteArrayOutputStream();
    private boolean broken;
    private volatile long arrivedBytes;
    private volatile long knownBytes;

    /**
     * Creates a decoder that expects the beginning of a frame.
     *
     * @param mostBytes the length of the longest message that is kept
     */
    WebSocketFrames(int mostBytes) {
        this.mostBytes = mostBytes;
    }

    /**
     * Decodes bytes; keeps a partial message for the next call. Decodes nothing behind a
     * {@link WebSocketMessage.Violation}.
     *
     * @param bytes read to the end
     * @param messages receives each whole message
     */
    void decode(ByteBuffer bytes, Consumer<WebSocketMessage> messages) {
        try {
            while (!broken && bytes.hasRemaining()) {
                readPart(bytes, messages);
            }
        } catch (IllegalArgumentException e) {
            broken = true;
            messages.accept(new WebSocketMessage.Violation(String.valueOf(e.getMessage())));
        }
    }

    /** Reads one byte of a header, or what there is of a content. */
    private void readPart(ByteBuffer bytes, Consumer<WebSocketMessage> messages) {
        FrameHeader current = frame;
        if (current == null) {
            header.put(bytes.get());
            current = FrameHeader.read(header);
            if (current == null) {
                return;
            }
            header.clear();
            frame = current;
            begin(current);
        } else {
            readContent(current, bytes);
        }
        if (left == 0) {
            frame = null;
            end(current, messages);
        }
    }

    private void begin(FrameHeader next) {
        left = next.length();
        if (next.opcode().isControl()) {
            control = new ByteArrayOutputStream();
        } else if (next.opcode() != Opcode.CONTINUATION) {
            if (message != null) {
                throw new IllegalArgumentException("a message inside another one");
            }
            kind = next.opcode();
            message = new ByteArrayOutputStream();
            tooLong = false;
        } else if (message == null) {
            throw new IllegalArgumentException("the continuation of no message");
        }
        if (!next.opcode().isControl()) {
            knownBytes = arrivedBytes + next.length();
        }
    }

    /** Returns how much has arrived of a message that is not complete, bytes; 0 between messages. For any thread. */
    long arrivedBytes() {
        return arrivedBytes;
    }

    /** Returns the length of this message as far as its frames have begun, bytes. For any thread. */
    long knownBytes() {
        return knownBytes;
    }

    private void readContent(FrameHeader current, ByteBuffer bytes) {
        int count = (int) Math.min(left, bytes.remaining());
        left -= count;
        byte[] part = new byte[count];
        bytes.get(part);
        if (current.opcode().isControl()) {
            control.writeBytes(part);
            return;
        }
        arrivedBytes += count;
        if (message != null && !tooLong) {
            keep(message, part);
        }
    }

    private void keep(ByteArrayOutputStream content, byte[] part) {
        tooLong = content.size() + part.length > mostBytes;
        if (tooLong) {
            message = new ByteArrayOutputStream();
        } else {
            content.writeBytes(part);
        }
    }

    private void end(FrameHeader complete, Consumer<WebSocketMessage> messages) {
        if (complete.opcode().isControl()) {
            messages.accept(controlMessage(complete.opcode(), control.toByteArray()));
        } else if (complete.last() && message != null) {
            byte[] content = message.toByteArray();
            message = null;
            arrivedBytes = 0;
            messages.accept(dataMessage(content));
        }
    }

    private WebSocketMessage dataMessage(byte[] content) {
        if (tooLong) {
            return new WebSocketMessage.TooLong();
        }
        return kind == Opcode.TEXT
                ? new WebSocketMessage.Text(new String(content, StandardCharsets.UTF_8))
                : new WebSocketMessage.Binary(content);
    }

    private static WebSocketMessage controlMessage(Opcode opcode, byte[] content) {
        return switch (opcode) {
            case PING -> new WebSocketMessage.Ping(content);
            case PONG -> new WebSocketMessage.Pong(content);
            default -> close(content);
        };
    }

    private static WebSocketMessage close(byte[] content) {
        if (content.length < Short.BYTES) {
            return new WebSocketMessage.Close(NO_CODE, "");
        }
        int code = ByteBuffer.wrap(content).getShort() & 0xFFFF;
        String reason = new String(content, Short.BYTES, content.length - Short.BYTES, StandardCharsets.UTF_8);
        return new WebSocketMessage.Close(code, reason);
    }
}

package majic.ros.websocket;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/** Decodes all that a client receives: first the answer to its request, then frames. Used by one thread. */
final class ServerBytes {
    private static final int LONGEST_ANSWER = 16_384;
    private static final String END = "\r\n\r\n";

    private final WebSocketFrames frames;
    private final ByteArrayOutputStream head = new ByteArrayOutputStream();
    private int matched;
    private boolean answered;

    ServerBytes(int mostBytes) {
        frames = new WebSocketFrames(mostBytes);
    }

    /** The decoder of what follows the answer. */
    WebSocketFrames frames() {
        return frames;
    }

    /**
     * Decodes bytes; keeps what is incomplete for the next call.
     *
     * @param bytes from index 0 on
     * @param count how many
     * @param messages receives each whole message
     */
    void decode(byte[] bytes, int count, Consumer<WebSocketMessage> messages) {
        ByteBuffer buffer = ByteBuffer.wrap(bytes, 0, count);
        while (!answered && buffer.hasRemaining()) {
            readAnswer(buffer.get(), messages);
        }
        frames.decode(buffer, messages);
    }

    private void readAnswer(byte next, Consumer<WebSocketMessage> messages) {
        head.write(next);
        if (next == END.charAt(matched)) {
            matched++;
        } else {
            matched = next == END.charAt(0) ? 1 : 0;
        }
        if (matched == END.length() || head.size() == LONGEST_ANSWER) {
            answered = true;
            messages.accept(new WebSocketMessage.Answer(head.toString(StandardCharsets.ISO_8859_1)));
            head.reset();
        }
    }
}

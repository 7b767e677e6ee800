package majic.hemisson.line;

import java.io.IOException;
import java.util.function.Consumer;
import majic.driver.FirstBytes;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.link.Link;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** One connection, from opening to its end: the link, its reader thread and the conversation over it. */
public final class HemissonSession {
    private final Link link;
    private final ConversationListener listener;
    private final Conversation conversation;
    private final LineTimes times;
    private final FirstBytes firstBytes = new FirstBytes();
    private volatile boolean closed;
    private volatile @Nullable String end;
    private volatile boolean recognised;

    HemissonSession(Link link, TimeSource time, ConversationListener listener) {
        this.link = link;
        this.listener = listener;
        this.times = LineTimes.of(link.address());
        this.conversation = new Conversation(link, time, times, listener);
    }

    public void start() {
        new LinkReader<>(link, "the serial server closed it", new Lines()).start("hemisson reader");
    }

    public Conversation conversation() {
        return conversation;
    }

    /** How long an answer may take, seconds. */
    public double timeoutSeconds() {
        return times.answerSeconds();
    }

    /** The first bytes received, from which another device can be identified. */
    FirstBytes firstBytes() {
        return firstBytes;
    }

    /** Whether a line was received as a Hemisson sends it. */
    boolean isRecognised() {
        return recognised;
    }

    /** Whether the robot is behind a serial server, not at a port of this computer. */
    boolean isOnNetwork() {
        return link.address().startsWith("tcp:");
    }

    public boolean isClosed() {
        return closed;
    }

    /** The cause of the end of the link; null if it did not end by itself. */
    @Nullable
    String end() {
        return end;
    }

    public void close() {
        closed = true;
        conversation.end("the connection was closed");
        link.close();
    }

    /** Lines of text, for the conversation. */
    private final class Lines implements LinkHandler<String> {
        private final ReplyDecoder decoder = new ReplyDecoder();

        @Override
        public void decode(byte[] bytes, int count, Consumer<String> messages) {
            conversation.bytesReceived();
            firstBytes.received(bytes, count);
            decoder.feed(bytes, count).forEach(messages);
        }

        @Override
        public void received(String line) {
            Reply reply = Reply.of(line);
            recognised |= reply.isTypical();
            conversation.received(reply);
        }

        @Override
        public void ended(IOException cause) {
            if (!closed) {
                end = cause.getMessage();
                listener.broken(cause);
            }
        }
    }
}

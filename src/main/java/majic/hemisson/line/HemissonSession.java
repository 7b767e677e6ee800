package majic.hemisson.line;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
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
    private volatile boolean closed;
    private volatile @Nullable String end;
    private volatile boolean telnet;

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

    /** Whether the peer negotiates telnet options, so that what it sends is no raw serial line. */
    boolean isTelnet() {
        return telnet;
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
            List<String> lines = decoder.feed(bytes, count);
            telnet = decoder.isTelnet();
            lines.forEach(messages);
        }

        @Override
        public void received(String line) {
            conversation.received(Reply.of(line));
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

package majic.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/** Answers that wait until a client reads them. Lines are added on any thread, and sent on the server's. */
final class AnswerQueue {
    private static final int CHARS_AT_ONCE = 8000;

    private final LineBuffer lines;
    private volatile boolean overflowed;
    private volatile @Nullable ByteBuffer begun;

    AnswerQueue(int mostLines, int mostChars) {
        lines = new LineBuffer(mostLines, mostChars);
    }

    /** Appends a line, its control characters made visible; never blocks. */
    void add(String text) {
        overflowed |= !lines.add(VisibleText.of(text));
    }

    /** Returns whether a line was left out because too many wait. */
    boolean hasOverflowed() {
        return overflowed;
    }

    /** Replaces the lines of which nothing has been sent. */
    void replaceBy(String text) {
        lines.clear();
        add(text);
    }

    /** Sends as much as the connection takes now. */
    void send(Wire wire) throws IOException {
        wire.flush();
        if (begun == null) {
            begun = next();
        }
        while (begun != null && wire.isOpen()) {
            wire.write(begun);
            if (begun.hasRemaining()) {
                break;
            }
            begun = next();
        }
    }

    private @Nullable ByteBuffer next() {
        StringBuilder text = new StringBuilder();
        for (String line = lines.poll(); line != null; line = text.length() < CHARS_AT_ONCE ? lines.poll() : null) {
            text.append(line).append('\n');
        }
        return text.isEmpty() ? null : ByteBuffer.wrap(text.toString().getBytes(StandardCharsets.UTF_8));
    }

    boolean isEmpty() {
        return begun == null && lines.isEmpty();
    }
}

package majic.server;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/** Lines that wait, of limited number and total length. Thread-safe. */
final class LineBuffer {
    private final int mostLines;
    private final int mostChars;
    private final Deque<String> lines = new ArrayDeque<>();
    private int chars;

    LineBuffer(int mostLines, int mostChars) {
        this.mostLines = mostLines;
        this.mostChars = mostChars;
    }

    /** Appends a line; returns false, and leaves it out, if there is no room for it. */
    synchronized boolean add(String line) {
        if (lines.size() >= mostLines || chars + line.length() > mostChars) {
            return false;
        }
        lines.add(line);
        chars += line.length();
        return true;
    }

    /** Returns the oldest line; null if there is none. */
    synchronized @Nullable String peek() {
        return lines.peek();
    }

    /** Removes and returns the oldest line; null if there is none. */
    synchronized @Nullable String poll() {
        String line = lines.poll();
        chars -= line == null ? 0 : line.length();
        return line;
    }

    synchronized int size() {
        return lines.size();
    }

    boolean isEmpty() {
        return size() == 0;
    }

    synchronized void clear() {
        lines.clear();
        chars = 0;
    }
}

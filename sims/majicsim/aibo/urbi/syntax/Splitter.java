package majicsim.aibo.urbi.syntax;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Cuts a client's byte stream into commands (URBI sheet, section 3). A command ends at {@code ;} or {@code ,} outside
 * brackets, quotes and comments; it is returned with its separator. Bytes are characters of the same number (ISO
 * 8859-1).
 */
final class Splitter {
    /** The longest command; a longer one is lost (sheet, section 2). */
    static final int LIMIT = 32 * 1024;

    private enum Mode {
        PLAIN,
        STRING,
        STRING_ESCAPE,
        LINE_COMMENT,
        BLOCK_COMMENT
    }

    private final StringBuilder command = new StringBuilder();
    private byte[] input = new byte[0];
    private int position;
    private Mode mode = Mode.PLAIN;
    private int depth;
    private char previous;
    private boolean skipping;
    private boolean overflow;

    void feed(byte[] bytes) {
        int rest = input.length - position;
        byte[] joined = new byte[rest + bytes.length];
        System.arraycopy(input, position, joined, 0, rest);
        System.arraycopy(bytes, 0, joined, rest, bytes.length);
        input = joined;
        position = 0;
    }

    /** The next complete command with its separator, or null when more bytes are needed. */
    @Nullable
    String next() {
        while (position < input.length) {
            char c = (char) (input[position++] & 0xFF);
            if (accept(c)) {
                String done = command.toString();
                boolean lost = skipping;
                clear();
                if (!lost) {
                    return done;
                }
            }
        }
        return null;
    }

    /** The next bytes as they are, or null (and nothing taken) while fewer have arrived. */
    byte @Nullable [] take(int size) {
        if (input.length - position < size) {
            return null;
        }
        byte[] taken = Arrays.copyOfRange(input, position, position + size);
        position += size;
        return taken;
    }

    /** Whether a command outgrew the receive buffer since the last call. */
    boolean overflowed() {
        boolean was = overflow;
        overflow = false;
        return was;
    }

    private boolean accept(char c) {
        keep(c);
        switch (mode) {
            case PLAIN -> {
                return plain(c);
            }
            case STRING -> mode = c == '"' ? Mode.PLAIN : c == '\\' ? Mode.STRING_ESCAPE : Mode.STRING;
            case STRING_ESCAPE -> mode = Mode.STRING;
            case LINE_COMMENT -> mode = c == '\n' ? Mode.PLAIN : Mode.LINE_COMMENT;
            case BLOCK_COMMENT -> endBlockComment(c);
        }
        return false;
    }

    private void keep(char c) {
        if (skipping) {
            return;
        }
        command.append(c);
        if (command.length() > LIMIT) {
            command.setLength(0);
            skipping = true;
            overflow = true;
        }
    }

    private boolean plain(char c) {
        char before = previous;
        previous = c;
        switch (c) {
            case '"' -> mode = Mode.STRING;
            case '#' -> mode = Mode.LINE_COMMENT;
            case '(', '[', '{' -> depth++;
            case ')', ']', '}' -> depth = Math.max(0, depth - 1);
            case ';', ',' -> {
                return depth == 0;
            }
            default -> pair(before, c);
        }
        return false;
    }

    private void pair(char before, char c) {
        if (before == '/' && c == '/') {
            mode = Mode.LINE_COMMENT;
        } else if (before == '/' && c == '*') {
            mode = Mode.BLOCK_COMMENT;
            previous = 0;
        } else if (before == '$' && c == '$') {
            clear();
        }
    }

    private void endBlockComment(char c) {
        if (previous == '*' && c == '/') {
            mode = Mode.PLAIN;
            previous = 0;
        } else {
            previous = c;
        }
    }

    private void clear() {
        command.setLength(0);
        mode = Mode.PLAIN;
        depth = 0;
        previous = 0;
        skipping = false;
    }
}

package majic.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Cuts what an URBI server sends into messages (URBI sheet 4). Messages end with a line feed, except that a line feed
 * inside the quotes of a value belongs to it, that {@code BIN n} is followed by n raw bytes, and that nothing follows
 * these bytes unless they stand in a list. A text of more than {@value #MAX_TEXT} bytes or a binary of more than
 * {@value #MAX_BINARY} is dropped up to the next line feed. Where bytes were lost, a quote that does not close is given
 * up at the next line with a prefix, a binary when its reader gives it up. No socket, thread or clock; used by one
 * thread.
 */
public final class UrbiDecoder {
    static final int MAX_TEXT = 64 * 1024;
    static final int MAX_BINARY = 16 * 1024 * 1024;

    private static final Pattern BINARY_HEADER = Pattern.compile("BIN (\\d{1,9})(?: .*)?");

    private byte[] bytes = new byte[1024];
    private int length;
    private @Nullable UrbiPrefix prefix;
    private boolean prefixDecided;
    private int bodyStart;
    private final UrbiBodyScan scan = new UrbiBodyScan();
    private int binaryLeft;
    private int binaryBytes;
    private boolean skipping;
    private String lastInfoTag = UrbiMessage.NO_TAG;
    private long lastTimeMs;
    private List<UrbiMessage> found = new ArrayList<>();

    /** Takes the first {@code count} bytes of a chunk and gives the messages that are complete now. */
    public List<UrbiMessage> feed(byte[] chunk, int count) {
        found = new ArrayList<>();
        int at = 0;
        while (at < count) {
            if (binaryLeft > 0) {
                int taken = Math.min(binaryLeft, count - at);
                takeBinary(chunk, at, taken);
                at += taken;
            } else {
                takeText(chunk[at++]);
            }
        }
        return found;
    }

    /** Whether more raw bytes of a binary are expected. */
    public boolean isInBinary() {
        return binaryLeft > 0;
    }

    /**
     * Discards the unfinished binary if the bytes received for it contain a message, because then it was cut short;
     * returns that message and those after it. Otherwise keeps the binary: the link may only be slow.
     */
    public List<UrbiMessage> giveUpCutBinary() {
        int next = isInBinary() ? UrbiPrefix.find(bytes, bodyStart, length) : -1;
        if (next < 0) {
            return List.of();
        }
        byte[] rest = Arrays.copyOfRange(bytes, next, length);
        reset();
        return feed(rest, rest.length);
    }

    private void takeBinary(byte[] chunk, int from, int count) {
        reserve(count);
        System.arraycopy(chunk, from, bytes, length, count);
        length += count;
        binaryLeft -= count;
        if (binaryLeft == 0) {
            binaryEnds();
        }
    }

    private void takeText(byte next) {
        if (skipping) {
            skipping = next != '\n';
            return;
        }
        reserve(1);
        bytes[length++] = next;
        if (next == '\n' && !scan.isQuoted()) {
            lineEnds();
        } else if (length - binaryBytes > MAX_TEXT) {
            skipping = next != '\n';
            reset();
        } else if (prefix != null) {
            takeBody(next);
            restartAtPrefix(next);
        } else if (next == ']' && !prefixDecided) {
            prefixDecided = true;
            prefix = UrbiPrefix.parse(bytes, length);
            bodyStart = length;
        }
    }

    private void takeBody(byte next) {
        boolean blankBehindPrefix = length - 1 == bodyStart && next == ' ' && bytes[bodyStart - 1] == ']';
        if (blankBehindPrefix) {
            bodyStart++;
        } else {
            scan.take(next, length - 1, bodyStart);
        }
    }

    /** A quote that never closed hides the messages behind it, until one of them begins a line. */
    private void restartAtPrefix(byte next) {
        if (next != ']' || !scan.isQuoted()) {
            return;
        }
        int lineStart = length;
        while (lineStart > bodyStart && bytes[lineStart - 1] != '\n') {
            lineStart--;
        }
        if (lineStart > bodyStart && UrbiPrefix.find(bytes, lineStart, length) == lineStart) {
            byte[] rest = Arrays.copyOfRange(bytes, lineStart, length);
            reset();
            for (byte again : rest) {
                takeText(again);
            }
        }
    }

    private void lineEnds() {
        if (prefix == null) {
            emitContinuation();
            return;
        }
        int size = binarySize();
        if (size < 0) {
            emit();
        } else if (size > MAX_BINARY) {
            reset();
        } else {
            binaryLeft = size;
            binaryBytes += size;
            if (size == 0) {
                binaryEnds();
            }
        }
    }

    /** The number of raw bytes that follow the line just ended, or −1 if none do. */
    private int binarySize() {
        int from = scan.elementStart(bodyStart);
        String element = text(from, length);
        Matcher header = BINARY_HEADER.matcher(element);
        return header.matches() ? Integer.parseInt(header.group(1)) : -1;
    }

    private void binaryEnds() {
        if (scan.isInList()) {
            scan.elementStarts(length);
        } else {
            emit();
        }
    }

    private void emit() {
        UrbiPrefix known = prefix;
        if (known != null) {
            UrbiMessage.Body body = UrbiBodies.parse(bytes, bodyStart, length);
            found.add(new UrbiMessage(known.timeMs(), known.tag(), body));
            lastInfoTag = body instanceof UrbiMessage.Info ? known.tag() : lastInfoTag;
            lastTimeMs = known.timeMs();
        }
        reset();
    }

    private void emitContinuation() {
        found.add(new UrbiMessage(lastTimeMs, lastInfoTag, new UrbiMessage.Continued(text(0, length))));
        reset();
    }

    private String text(int from, int to) {
        return new String(bytes, from, Math.max(0, to - from), StandardCharsets.ISO_8859_1).stripTrailing();
    }

    private void reset() {
        if (bytes.length > MAX_TEXT) {
            bytes = new byte[1024];
        }
        length = 0;
        prefix = null;
        prefixDecided = false;
        binaryBytes = 0;
        binaryLeft = 0;
        scan.reset();
    }

    private void reserve(int more) {
        if (length + more > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(bytes.length * 2, length + more));
        }
    }
}

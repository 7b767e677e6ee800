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

    private static final byte BINARY_MARK = 'B';

    private byte[] bytes = new byte[1024];
    private int length;

    /** Up to where the text has been searched for its prefix, quotes and brackets. */
    private int scanned;

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
                at = takeText(chunk, at, count);
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
        append(chunk, from, count);
        binaryLeft -= count;
        if (binaryLeft == 0) {
            binaryEnds();
        }
    }

    /** Takes bytes of text up to the end of a line, or those that there are; returns the index behind them. */
    private int takeText(byte[] chunk, int from, int end) {
        int to = from;
        while (to < end && chunk[to] != '\n') {
            to++;
        }
        boolean ends = to < end;
        if (skipping) {
            skipping = !ends;
            return ends ? to + 1 : to;
        }
        int most = MAX_TEXT + 1 - (length - binaryBytes);
        int taken = Math.min(most, (ends ? to + 1 : to) - from);
        append(chunk, from, taken);
        if (prefix == null && !prefixDecided) {
            decidePrefix();
        }
        if (prefix != null) {
            scanBody();
        }
        textTaken();
        return from + taken;
    }

    /** Ends a line, or drops a text that is too long. */
    private void textTaken() {
        boolean lineFeed = length > 0 && bytes[length - 1] == '\n';
        if (lineFeed && !scan.isQuoted()) {
            lineEnds();
        } else if (length - binaryBytes > MAX_TEXT) {
            skipping = !lineFeed;
            reset();
        }
    }

    /** Reads the prefix at the first closing bracket of a line. */
    private void decidePrefix() {
        while (scanned < length && !prefixDecided) {
            prefixDecided = bytes[scanned++] == ']';
        }
        if (prefixDecided) {
            prefix = UrbiPrefix.parse(bytes, scanned);
            bodyStart = scanned;
        }
    }

    private void scanBody() {
        boolean blankBehindPrefix = scanned == bodyStart && scanned < length && bytes[scanned] == ' ';
        if (blankBehindPrefix && bytes[bodyStart - 1] == ']') {
            bodyStart++;
            scanned++;
        }
        while (scanned < length) {
            scanned = scan.take(bytes, scanned, length, bodyStart);
            if (scan.isQuoted() && bytes[scanned - 1] == ']' && restartAtPrefix()) {
                return;
            }
        }
    }

    /** A quote that never closed hides the messages behind it, until one of them begins a line. */
    private boolean restartAtPrefix() {
        int lineStart = scanned;
        while (lineStart > bodyStart && bytes[lineStart - 1] != '\n') {
            lineStart--;
        }
        if (lineStart == bodyStart || UrbiPrefix.find(bytes, lineStart, scanned) != lineStart) {
            return false;
        }
        byte[] rest = Arrays.copyOfRange(bytes, lineStart, length);
        reset();
        append(rest, 0, rest.length);
        decidePrefix();
        scanBody();
        return true;
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
        if (from >= length || bytes[from] != BINARY_MARK) {
            return -1;
        }
        String element = text(from, length);
        Matcher header = BINARY_HEADER.matcher(element);
        return header.matches() ? Integer.parseInt(header.group(1)) : -1;
    }

    private void binaryEnds() {
        if (scan.isInList()) {
            scanned = length;
            scan.elementStarts(length);
        } else {
            emit();
        }
    }

    private void emit() {
        UrbiPrefix known = prefix;
        if (known != null) {
            UrbiMessage.Body body = UrbiMessage.Body.parse(bytes, bodyStart, length);
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
        scanned = 0;
        prefix = null;
        prefixDecided = false;
        binaryBytes = 0;
        binaryLeft = 0;
        scan.reset();
    }

    private void append(byte[] chunk, int from, int count) {
        if (length + count > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(bytes.length * 2, length + count));
        }
        System.arraycopy(chunk, from, bytes, length, count);
        length += count;
    }
}

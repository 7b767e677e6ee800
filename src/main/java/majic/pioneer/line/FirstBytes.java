package majic.pioneer.line;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

/** The first bytes received on a line, from which a device that is no Pioneer can be identified. Thread-safe. */
final class FirstBytes {
    private static final int MOST = 400;
    private static final int LONGEST_LINE = 80;

    /** A line with fewer letters is decoration, such as the row of stars that URBI begins with. */
    private static final int FEWEST_LETTERS = 8;

    private static final int TELNET_IAC = 0xFF;
    private static final int TELNET_WILL = 0xFB;
    private static final int TELNET_DONT = 0xFE;

    private final byte[] bytes = new byte[MOST];
    private int filled;

    /** Adds received bytes; called by the reader thread. */
    synchronized void received(byte[] chunk, int count) {
        int taken = Math.min(count, MOST - filled);
        System.arraycopy(chunk, 0, bytes, filled, taken);
        filled += taken;
    }

    synchronized boolean isEmpty() {
        return filled == 0;
    }

    /** Whether they begin a telnet negotiation, as those of an RFC 2217 serial server do. */
    synchronized boolean isTelnet() {
        return filled >= 2 && at(0) == TELNET_IAC && at(1) >= TELNET_WILL && at(1) <= TELNET_DONT;
    }

    /** The first line of readable text, cut to 80 characters; null if there is none. */
    synchronized @Nullable String line() {
        return new String(bytes, 0, filled, StandardCharsets.ISO_8859_1)
                .lines()
                .map(String::strip)
                .filter(FirstBytes::isText)
                .map(line -> line.substring(0, Math.min(line.length(), LONGEST_LINE)))
                .findFirst()
                .orElse(null);
    }

    private static boolean isText(String line) {
        return line.chars().allMatch(FirstBytes::isPrintable)
                && line.chars().filter(Character::isLetter).count() >= FEWEST_LETTERS;
    }

    private int at(int index) {
        return bytes[index] & 0xFF;
    }

    private static boolean isPrintable(int character) {
        return character >= ' ' && character <= '~' || character == '\t';
    }
}

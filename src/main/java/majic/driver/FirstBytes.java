package majic.driver;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

/**
 * The first bytes received on a link, from which a device of another kind than the expected robot can be identified.
 * Thread-safe.
 */
public final class FirstBytes {
    private static final int MOST = 400;
    private static final int LONGEST_LINE = 80;

    /** A line with fewer letters is decoration, such as the row of stars that URBI begins with. */
    private static final int FEWEST_LETTERS = 8;

    private static final int TELNET_IAC = 0xFF;
    private static final int TELNET_WILL = 0xFB;
    private static final int TELNET_DONT = 0xFE;

    private final byte[] bytes = new byte[MOST];
    private int filled;

    /** Creates an empty record. */
    public FirstBytes() {}

    /**
     * Adds received bytes; for the reader thread.
     *
     * @param chunk the bytes
     * @param count how many of them were received
     */
    public synchronized void received(byte[] chunk, int count) {
        int taken = Math.min(count, MOST - filled);
        System.arraycopy(chunk, 0, bytes, filled, taken);
        filled += taken;
    }

    /**
     * Returns whether nothing was received.
     *
     * @return true until the first byte
     */
    public synchronized boolean isEmpty() {
        return filled == 0;
    }

    /**
     * Returns whether the bytes begin a telnet negotiation, as those of an RFC 2217 serial server do: what follows is
     * no raw serial line.
     *
     * @return true if they do
     */
    public synchronized boolean isTelnet() {
        return filled >= 2 && at(0) == TELNET_IAC && at(1) >= TELNET_WILL && at(1) <= TELNET_DONT;
    }

    /**
     * Returns whether the bytes are the answer of a web server.
     *
     * @return true if they are
     */
    public boolean isWebServer() {
        String line = line();
        return line != null && line.startsWith("HTTP/");
    }

    /**
     * Returns the bytes as characters of the same number.
     *
     * @return the first 400; empty if nothing was received
     */
    public synchronized String text() {
        return new String(bytes, 0, filled, StandardCharsets.ISO_8859_1);
    }

    /**
     * Returns the first line of readable text.
     *
     * @return the line, cut to 80 characters; null if there is none
     */
    public @Nullable String line() {
        return text().lines()
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

package majic.act;

import java.util.regex.Pattern;

/**
 * Makes texts read from files safe to show: without line ends, control characters or characters that reverse the
 * writing direction.
 */
public final class Printable {
    private static final Pattern UNSEEN = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]");

    private Printable() {}

    /**
     * Replaces invisible characters in a text.
     *
     * @param text any text
     * @return the text with a question mark for each invisible character
     */
    public static String of(String text) {
        return UNSEEN.matcher(text).replaceAll("?");
    }

    /** Returns the text in one line, with a blank for each invisible character. */
    static String line(String text) {
        return UNSEEN.matcher(text).replaceAll(" ").strip().replaceAll("\\s+", " ");
    }
}

package majic.act;

import java.util.regex.Pattern;

/** Makes texts out of files safe to show: no line ends, no control characters, nothing that turns the writing round. */
public final class Printable {
    private static final Pattern UNSEEN = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]");

    private Printable() {}

    /**
     * A text of which everything can be seen.
     *
     * @param text anything
     * @return it with a question mark for each character that cannot be seen
     */
    public static String of(String text) {
        return UNSEEN.matcher(text).replaceAll("?");
    }

    /** The text in one line, a blank for whatever cannot be seen. */
    static String line(String text) {
        return UNSEEN.matcher(text).replaceAll(" ").strip().replaceAll("\\s+", " ");
    }
}

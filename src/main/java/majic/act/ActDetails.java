package majic.act;

import java.util.regex.Pattern;

/**
 * The author's description of an act. Each text is one line without control characters or characters that reverse the
 * writing direction.
 *
 * @param name the act's name, as in {@code act NAME}
 * @param version the author's version number; may be empty
 * @param author the author's name; may be empty
 * @param description one or two sentences; may be empty
 */
public record ActDetails(String name, String version, String author, String description) {
    private static final Pattern UNSEEN = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]");

    /** Turns each text into one line. */
    public ActDetails {
        name = oneLine(name);
        version = oneLine(version);
        author = oneLine(author);
        description = oneLine(description);
    }

    /** Returns a text in one line, with a blank in place of characters that a screen does not show. */
    static String oneLine(String text) {
        return UNSEEN.matcher(text).replaceAll(" ").strip().replaceAll("\\s+", " ");
    }

    /**
     * Returns details that hold only a name.
     *
     * @param name the act's name
     * @return details with everything else empty
     */
    public static ActDetails named(String name) {
        return new ActDetails(name, "", "", "");
    }
}

package majic.text;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Makes text of any origin safe to show in one line. Line ends, escape sequences of terminals and characters that
 * reverse the writing direction become visible, so that no text can be mistaken for a separate line or change what a
 * screen shows.
 */
public final class VisibleText {
    private static final Pattern UNSAFE = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Cs}\\p{Zl}\\p{Zp}]");

    private VisibleText() {}

    /**
     * Returns the text in one line of visible characters.
     *
     * @param text anything
     * @return the text with {@code \n}, {@code \r} and {@code \}{@code u001b} and the like, written out, in place of
     *     unsafe characters, and blanks in place of tabs
     */
    public static String of(String text) {
        return isPlain(text)
                ? text
                : UNSAFE.matcher(text.replace('\t', ' '))
                        .replaceAll(found -> Matcher.quoteReplacement(escape(found.group())));
    }

    /** Most texts are plain, and the pattern takes much longer than this. */
    private static boolean isPlain(String text) {
        for (int at = 0; at < text.length(); at++) {
            if (text.charAt(at) < ' ' || text.charAt(at) > '~') {
                return false;
            }
        }
        return true;
    }

    /**
     * Cuts a text that may be too long, never inside of a character.
     *
     * @param text anything
     * @param most how many UTF-16 units remain at most, above 0
     * @return the text, or its beginning
     */
    public static String beginning(String text, int most) {
        if (text.length() <= most) {
            return text;
        }
        return text.substring(0, Character.isHighSurrogate(text.charAt(most - 1)) ? most - 1 : most);
    }

    private static String escape(String unsafe) {
        return switch (unsafe) {
            case "\n" -> "\\n";
            case "\r" -> "\\r";
            default ->
                unsafe.chars().mapToObj(unit -> String.format("\\u%04x", unit)).collect(Collectors.joining());
        };
    }
}

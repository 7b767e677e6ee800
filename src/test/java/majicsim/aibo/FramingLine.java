package majicsim.aibo;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** One line of the framing capture: the bytes that were sent and the lines that came back, without time stamps. */
record FramingLine(String sent, String received) {
    private static final Pattern LINE = Pattern.compile("SEND b'(.*)' -> b'(.*)'");
    private static final Pattern ESCAPE = Pattern.compile("\\\\(n|r|'|\\\\|x[0-9a-f]{2})");

    static FramingLine parse(String line) {
        Matcher matcher = LINE.matcher(line);
        if (!matcher.matches()) {
            throw new IllegalArgumentException("not a line of the framing capture: " + line);
        }
        String received =
                unescape(matcher.group(2)).replaceAll("(?m)^\\[\\d{8,}:", "[").stripTrailing();
        return new FramingLine(unescape(matcher.group(1)), received);
    }

    /** The capture shows only the first bytes of a very long line; nothing can be compared from there on. */
    boolean isCut() {
        return sent.length() >= 100;
    }

    private static String unescape(String text) {
        return ESCAPE.matcher(text)
                .replaceAll(found -> Matcher.quoteReplacement(
                        switch (found.group(1).charAt(0)) {
                            case 'n' -> "\n";
                            case 'r' -> "\r";
                            case 'x' ->
                                String.valueOf(
                                        (char) Integer.parseInt(found.group(1).substring(1), 16));
                            default -> found.group(1);
                        }));
    }
}

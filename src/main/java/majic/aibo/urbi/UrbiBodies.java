package majic.aibo.urbi;

import java.nio.charset.StandardCharsets;

/** Distinguishes the three kinds of message: information, errors, values (URBI sheet 4). */
final class UrbiBodies {
    private static final String INFO = "***";
    private static final String FAILURE = "!!!";

    private UrbiBodies() {}

    /** Reads the body between two indices; the line feed at its end may be there or not. */
    static UrbiMessage.Body parse(byte[] bytes, int from, int to) {
        String mark = new String(bytes, from, Math.min(3, to - from), StandardCharsets.ISO_8859_1);
        return switch (mark) {
            case INFO -> new UrbiMessage.Info(rest(bytes, from, to));
            case FAILURE -> new UrbiMessage.Failure(rest(bytes, from, to));
            default -> new UrbiMessage.Result(new UrbiValueParser(bytes, from, to).parse());
        };
    }

    private static String rest(byte[] bytes, int from, int to) {
        String text = new String(bytes, from + 3, to - from - 3, StandardCharsets.ISO_8859_1).stripTrailing();
        return text.startsWith(" ") ? text.substring(1) : text;
    }
}

package majic.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * The size of a program's text without its comments, as {@code docs/results.md} defines it. Immutable.
 *
 * @param lines the lines that contain a letter or a digit
 * @param tokens the words, numbers and signs; a text in quotes counts as the words and signs in it
 * @param words the different words
 */
record ProgramSize(int lines, int tokens, int words) {
    private static final Pattern COMMENT_OR_TEXT =
            Pattern.compile("(?<text>\"(?:\\\\.|[^\"\\\\])*\")|//.*|/\\*(?s:.*?)\\*/");
    private static final Pattern TOKEN =
            Pattern.compile("[\\p{L}_]\\w*|\\d[\\w.]*|->|::|[=!<>]=|\\+\\+|--|&&|\\|\\||\\S");
    private static final Pattern WORD_OR_NUMBER = Pattern.compile("[\\p{L}\\d]");

    /** Counts a program in Java, C++, URBI or MAJIC Script. */
    static ProgramSize of(Path file) throws IOException {
        String code = withoutComments(Files.readString(file), file.toString().endsWith(".majic"));
        List<String> tokens =
                TOKEN.matcher(code).results().map(MatchResult::group).toList();
        return new ProgramSize(
                (int) code.lines()
                        .filter(line -> WORD_OR_NUMBER.matcher(line).find())
                        .count(),
                tokens.size(),
                (int) tokens.stream()
                        .filter(token -> Character.isLetter(token.charAt(0)))
                        .distinct()
                        .count());
    }

    /** Also removes what stands for control characters in quotes, such as a line feed. */
    private static String withoutComments(String text, boolean isScript) {
        return isScript
                ? text.replaceAll("#.*", "")
                : COMMENT_OR_TEXT
                        .matcher(text)
                        .replaceAll(found ->
                                found.group().startsWith("\"") ? found.group().replaceAll("\\\\.", " ") : "");
    }
}

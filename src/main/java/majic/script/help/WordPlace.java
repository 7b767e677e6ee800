package majic.script.help;

import java.util.List;
import majic.script.syntax.Scanner;
import majic.script.syntax.Token;

/**
 * Where a word stands in a line: tokens without a gap between them, such as a number with its unit. Immutable.
 *
 * @param start its first character, from 0
 * @param end behind its last character; equal to the start where no word is
 */
public record WordPlace(int start, int end) {
    /**
     * Finds the word that a place touches.
     *
     * @param line one line
     * @param index 0 to the length of the line
     * @return the word in which the index lies, or in front of or behind which; the index itself if there is none
     */
    public static WordPlace at(String line, int index) {
        List<Token> tokens =
                Scanner.scan(line).stream().filter(token -> !token.isEnd()).toList();
        int end = end(tokens, index);
        List<Token> before =
                tokens.stream().filter(token -> token.column() <= end).toList();
        return new WordPlace(start(before, end), end);
    }

    private static int end(List<Token> tokens, int index) {
        int end = index;
        for (Token token : tokens) {
            if (token.column() - 1 <= end && end < token.end() - 1 && !separates(token)) {
                end = token.end() - 1;
            }
        }
        return end;
    }

    /**
     * Returns where the tokens begin that stand together in front of a place.
     *
     * @param tokens those in front of the place
     * @return the place itself if a gap or a separator is in front of it
     */
    static int start(List<Token> tokens, int end) {
        int start = end;
        for (int index = tokens.size() - 1; index >= 0; index--) {
            Token token = tokens.get(index);
            if (token.end() - 1 != start || separates(token)) {
                break;
            }
            start = token.column() - 1;
        }
        return start;
    }

    /** Returns whether a token is a sign that separates words, and belongs to none. */
    static boolean separates(Token token) {
        return switch (token.kind()) {
            case COMMA, DOT, LEFT, RIGHT, OPERATOR, NEWLINE, END -> true;
            case NUMBER, SPAN, WORD, VARIABLE, QUOTED, OPEN_QUOTE, OTHER -> false;
        };
    }
}

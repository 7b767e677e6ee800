package majic.script;

import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;

/**
 * The reason why a line was refused, and the place of the wrong word. Immutable.
 *
 * @param message one sentence: what is wrong, where, and what would be right
 * @param isLineRight whether the reason is outside of the line, as a latched STOP is, so that the line may be accepted
 *     later without a change
 * @param from index of the first character of the wrong word in the line; 0 if the line is right
 * @param to index behind its last character; equal to {@code from}, at the end of the line, if no word of it is wrong
 *     but something is missing; 0 if the line is right
 */
public record Refusal(String message, boolean isLineRight, int from, int to) {

    static Refusal of(String line, String message, RuntimeException reason) {
        if (reason instanceof ScriptException mistake) {
            Token at = mistake.at();
            int from = at.column() - 1;
            int to = at.end() - 1;
            if (line.startsWith(at.written(), from) && to <= line.length()) {
                return new Refusal(message, false, from, to);
            }
        }
        return lineIsRight(message);
    }

    private static Refusal lineIsRight(String message) {
        return new Refusal(message, true, 0, 0);
    }

    /** Returns the refusal of the line without its first characters; what is wrong with those is outside of it. */
    Refusal without(int characters) {
        return to <= characters
                ? lineIsRight(message)
                : new Refusal(message, false, Math.max(0, from - characters), to - characters);
    }
}

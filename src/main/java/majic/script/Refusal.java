package majic.script;

import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;

/**
 * The reason why a line was refused, and the place of the wrong word. Immutable.
 *
 * @param message one sentence: what is wrong, where, and what would be right
 * @param from index of the first character of the wrong word in the line
 * @param to index behind its last character; equal to {@code from}, at the end of the line, if no word of it is wrong
 *     but something is missing; both 0 if the reason is outside of the line, as a latched STOP is
 */
public record Refusal(String message, int from, int to) {

    static Refusal of(String line, String message, RuntimeException reason) {
        if (reason instanceof ScriptException mistake) {
            Token at = mistake.at();
            int from = at.column() - 1;
            int to = at.end() - 1;
            if (line.startsWith(at.written(), from) && to <= line.length()) {
                return new Refusal(message, from, to);
            }
        }
        return new Refusal(message, 0, 0);
    }

    /**
     * Returns whether the line itself is right, and may be accepted later without a change.
     *
     * @return true if the reason is outside of the line
     */
    public boolean isForAnotherReason() {
        return to == 0;
    }

    /** Returns the refusal of the line without its first characters. */
    Refusal without(int characters) {
        return new Refusal(message, Math.max(0, from - characters), Math.max(0, to - characters));
    }
}

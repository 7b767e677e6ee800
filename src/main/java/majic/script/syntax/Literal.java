package majic.script.syntax;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import majic.bot.Value;

/**
 * A value as written in a script.
 *
 * @param at where
 * @param value a number in the unit that answers use, without unit if none was written; or a text
 * @param text as it was written
 */
public record Literal(Token at, Value value, String text) {
    /** The written characters without quotes, even if they look like a number. */
    public String unquoted() {
        return at.kind() == Token.Kind.QUOTED && text.equals(at.written()) ? at.text() : text;
    }

    /**
     * The file that is named.
     *
     * @throws ScriptException if no file can have that name
     */
    public Path path() {
        try {
            return Path.of(unquoted());
        } catch (InvalidPathException e) {
            throw new ScriptException(at, text + ": no file can have that name");
        }
    }
}

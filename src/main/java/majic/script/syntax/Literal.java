package majic.script.syntax;

import majic.bot.Value;

/**
 * A value as written in a script.
 *
 * @param at where
 * @param value a number in the unit that answers use, without unit if none was written; or a text
 * @param text as it was written
 */
public record Literal(Token at, Value value, String text) {}

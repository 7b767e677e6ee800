package majic.script.syntax;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.Map;
import majic.bot.Value;
import majic.script.syntax.Token.Kind;

/** Puts the values of a script's arguments in place of their names: {@code $speed}, {@code -$speed}. */
final class Variables {
    private Variables() {}

    /**
     * Returns the token to put in place of a variable, with the opposite sign for {@code -$speed}.
     *
     * @param values the arguments' values by name in lower case
     * @throws ScriptException if there is no argument of that name, or a text would get a sign
     */
    static Token fillIn(Token variable, Map<String, Value> values) {
        boolean negative = variable.text().startsWith("-");
        String name = variable.text().substring(negative ? 2 : 1);
        Value value = values.get(name.toLowerCase(Locale.ROOT));
        if (value == null) {
            throw new ScriptException(variable, variable.text() + ": no argument of that name; " + known(name, values));
        }
        if (value instanceof Value.Number number) {
            String amount = plain(negative ? -number.amount() : number.amount());
            return token(Kind.NUMBER, amount + number.unit().symbol(), variable);
        }
        if (negative) {
            throw new ScriptException(variable, variable.text() + ": " + value + " is not a number");
        }
        boolean isWord = value.toString().matches("\\p{L}[\\p{L}\\d_]*");
        return token(isWord ? Kind.WORD : Kind.QUOTED, value.toString(), variable);
    }

    private static Token token(Kind kind, String text, Token place) {
        return new Token(kind, text, place.line(), place.column(), place.end());
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }

    private static String known(String name, Map<String, Value> values) {
        return values.isEmpty()
                ? "a script file begins with its arguments: argument " + name + " = VALUE"
                : "this script has "
                        + String.join(", ", values.keySet().stream().sorted().toList());
    }
}

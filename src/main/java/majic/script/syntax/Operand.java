package majic.script.syntax;

import java.math.BigDecimal;
import java.math.RoundingMode;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.syntax.Token.Kind;

/**
 * A value in an expression. Before a run only its kind may be known.
 *
 * @param value the value; a sample of its kind if it is open
 * @param open whether only the kind is known, and the value when the line runs
 * @param any whether not even the kind is known
 */
public record Operand(Value value, boolean open, boolean any) {
    private static final int SIGNIFICANT = 3;
    private static final int MOST_DECIMALS = 12;

    /** Nothing is known of it yet. */
    public static final Operand ANY = new Operand(Value.of(0, Unit.NONE), true, true);

    /** A word or a text that is not known yet. */
    public static final Operand OPEN_WORD = new Operand(Value.text("word"), true, false);

    /** A known value. */
    public static Operand of(Value value) {
        return new Operand(value, false, false);
    }

    /** A number that is not known yet, in a known unit. */
    public static Operand open(Unit unit) {
        return new Operand(Value.of(0, unit == Unit.MS ? Unit.S : unit), true, false);
    }

    /** What is known of a value in a line before it runs. */
    public static Operand kindOf(Literal written) {
        Value value = written.computable();
        if (value instanceof Value.Number number) {
            boolean isAny = written.at().open() && number.unit() == Unit.NONE;
            return isAny ? ANY : open(number.unit());
        }
        return value instanceof Value.Clear ? ANY : OPEN_WORD;
    }

    /** The unit of a number; {@link Unit#NONE} for a bare number and for anything else. */
    public Unit unit() {
        return value instanceof Value.Number number ? number.unit() : Unit.NONE;
    }

    public boolean isNumber() {
        return !any && value instanceof Value.Number;
    }

    /** What it is, as messages say it. */
    public String kind() {
        if (!isNumber()) {
            return value instanceof Value.Clear ? "clear" : open ? "a word" : value.toString();
        }
        String symbol = unit() == Unit.NONE ? "a number without a unit" : "a number of " + unit().symbol();
        return open ? symbol : value.toString();
    }

    /** The token that stands for the value where a line has it. */
    Token token(Token place, int end) {
        if (any) {
            return new Token(Kind.NUMBER, "0", place.line(), place.column(), end, true);
        }
        if (value instanceof Value.Number number) {
            String written = plain(number) + number.unit().symbol();
            return new Token(Kind.NUMBER, written, place.line(), place.column(), end, open);
        }
        String text = value.toString();
        boolean isWord = text.matches("\\p{L}[\\p{L}\\d_]*");
        return new Token(isWord ? Kind.WORD : Kind.QUOTED, text, place.line(), place.column(), end, open);
    }

    /**
     * With two more decimals than answers show, and three significant digits at least, down to what the inexactness of
     * computing leaves of a difference.
     */
    private static String plain(Value.Number number) {
        BigDecimal amount = BigDecimal.valueOf(number.amount());
        int decimals = Math.max(number.unit().digits() + 2, 3);
        int significant = SIGNIFICANT - (amount.precision() - amount.scale());
        BigDecimal rounded =
                amount.setScale(Math.max(decimals, Math.min(significant, MOST_DECIMALS)), RoundingMode.HALF_UP);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}

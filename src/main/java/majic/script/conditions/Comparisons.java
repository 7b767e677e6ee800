package majic.script.conditions;

import java.util.Locale;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.syntax.Condition;
import majic.script.syntax.EachComparison;
import majic.script.syntax.Literal;
import majic.script.syntax.Operator;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Compares a parameter of one robot with the right-hand side of a comparison. */
public final class Comparisons {
    private static final String CLEAR = "clear";

    private Comparisons() {}

    /**
     * Checks whether a whole condition makes sense for the robots it names; reads nothing.
     *
     * @param own whose parameters are meant where no robot is named; null where there is none
     * @throws ScriptException if it does not, or a robot is not there
     */
    public static void check(Condition condition, Selection selection, @Nullable Member own) {
        condition.accept(new EachComparison(comparison -> ConditionEvaluator.asked(comparison, selection, own)
                .forEach(member -> check(comparison, member.bot()))));
    }

    /**
     * Checks whether the comparison makes sense for a robot; reads nothing.
     *
     * @throws ScriptException if it does not
     */
    static void check(Condition.Comparison comparison, MajicBot bot) {
        Parameter left = readable(comparison.parameter(), bot);
        Parameter right = rightParameter(comparison, left, bot);
        if (right == null) {
            constant(comparison, left);
        } else if (right.unit() != left.unit() || right.kind() != left.kind()) {
            throw new ScriptException(
                    comparison.value().at(),
                    right.name() + ": cannot be compared with " + left.name() + ", it is of another kind");
        }
        boolean ordered = left.kind() == Parameter.Kind.NUMBER;
        if (!ordered && !comparison.operator().isEquality()) {
            throw new ScriptException(
                    comparison.parameter(), left.name() + ": not a number; it can be compared with == and != only");
        }
    }

    /** Reads the robot and compares. */
    static Truth of(Condition.Comparison comparison, MajicBot bot) {
        Parameter left = readable(comparison.parameter(), bot);
        Parameter right = rightParameter(comparison, left, bot);
        Value actual = bot.get(left.name());
        Value wanted = right == null ? constant(comparison, left) : bot.get(right.name());
        if (actual instanceof Value.Unknown unknown) {
            return Truth.unknown(left.name() + " is " + unknown);
        }
        if (wanted instanceof Value.Unknown unknown && right != null) {
            return Truth.unknown(right.name() + " is " + unknown);
        }
        return Truth.of(holds(actual, comparison.operator(), wanted));
    }

    static boolean holds(Value actual, Operator operator, Value wanted) {
        if (actual instanceof Value.Text || actual instanceof Value.Many || wanted instanceof Value.Text) {
            boolean equal = actual.toString().equalsIgnoreCase(wanted.toString());
            return operator.isEquality() && equal == (operator == Operator.EQUAL);
        }
        return operator.holds(actual.number(), wanted.number());
    }

    private static Parameter readable(Token name, MajicBot bot) {
        try {
            Parameter parameter = bot.parameter(name.text());
            if (!parameter.readable()) {
                throw new ScriptException(name, parameter.name() + ": can be set but not read");
            }
            return parameter;
        } catch (ParameterException e) {
            throw new ScriptException(name, String.valueOf(e.getMessage()));
        }
    }

    /** The other parameter, if the right-hand side is the name of one and not a word that the left one may have. */
    private static @Nullable Parameter rightParameter(Condition.Comparison comparison, Parameter left, MajicBot bot) {
        Literal literal = comparison.value();
        boolean word = literal.at().kind() == Token.Kind.WORD;
        boolean number = left.kind() == Parameter.Kind.NUMBER;
        if (!word || isWordOf(left, literal.text()) || !(number || ConditionEvaluator.has(bot, literal.text()))) {
            return null;
        }
        return readable(literal.at(), bot);
    }

    private static boolean isWordOf(Parameter left, String word) {
        return switch (left.kind()) {
            case NUMBER, LIST -> word.equalsIgnoreCase(CLEAR);
            case YES_NO, ON_OFF ->
                switch (word.toLowerCase(Locale.ROOT)) {
                    case "yes", "no", "on", "off", "true", "false" -> true;
                    default -> false;
                };
            case CHOICE -> left.choices().stream().anyMatch(word::equalsIgnoreCase);
            case TEXT -> true;
        };
    }

    private static Value constant(Condition.Comparison comparison, Parameter left) {
        Literal literal = comparison.value();
        if (literal.text().equalsIgnoreCase(CLEAR) && left.kind() == Parameter.Kind.NUMBER) {
            return Value.CLEAR;
        }
        try {
            return unbounded(left).fit(literal.valueFor(left));
        } catch (BotException e) {
            throw new ScriptException(literal.at(), String.valueOf(e.getMessage()));
        }
    }

    /** A value that a reading is compared with may lie outside of what can be set, and may be any text. */
    private static Parameter unbounded(Parameter left) {
        Parameter.Kind kind = left.kind() == Parameter.Kind.LIST ? Parameter.Kind.TEXT : left.kind();
        Unit unit = left.unit();
        return switch (kind) {
            case NUMBER -> Parameter.number(left.name(), unit, left.help());
            case YES_NO, ON_OFF, CHOICE -> left;
            case TEXT, LIST -> Parameter.text(left.name(), left.help());
        };
    }
}

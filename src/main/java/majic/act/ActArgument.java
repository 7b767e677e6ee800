package majic.act;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/**
 * Describes an argument of an act: a value that may be given when the act is run. Immutable.
 *
 * @param parameter its name, unit, range and explanation; a single value
 * @param initial the value if none is given
 */
public record ActArgument(Parameter parameter, Value initial) {
    /** The most arguments that an act may have. */
    public static final int MOST = 20;

    private static final String WORD = "\\p{L}[\\p{L}\\d_]*";
    private static final String NUMBER = "-?\\d+(?:\\.\\d+)?";
    private static final Pattern NAME = Pattern.compile(WORD);
    private static final Pattern TYPED_TEXT = Pattern.compile("[^\"\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]*");
    private static final Pattern TEXT = Pattern.compile("(?<name>" + WORD + ") = (?:(?<number>" + NUMBER
            + ")(?<unit>[^\\d\\s]\\S*)?(?<whole> whole)?(?: from (?<from>" + NUMBER + "))?(?: to (?<to>" + NUMBER
            + "))?|(?<words>" + WORD + "(?: or " + WORD + ")*)|\"(?<text>[^\"]*)\") \"(?<help>[^\"]*)\"");

    /**
     * Puts the default into the form that the argument takes, and the explanation into one line without quotation
     * marks.
     *
     * @throws IllegalArgumentException if the name is not a letter and then letters, digits and {@code _}, the kind is
     *     a list, or the default cannot be typed or is not permitted; the message contains what would be right
     */
    public ActArgument {
        if (!NAME.matcher(parameter.name()).matches()) {
            throw new IllegalArgumentException(
                    "the name of an argument is a letter and then letters, digits and _, not " + parameter.name());
        }
        if (parameter.kind() == Parameter.Kind.LIST) {
            throw new IllegalArgumentException(parameter.name() + ": an argument is a single value");
        }
        parameter = explained(parameter);
        initial = fit(parameter, initial);
        if (!TYPED_TEXT.matcher(initial.toString()).matches()) {
            throw new IllegalArgumentException(
                    parameter.name() + ": its text is one line without quotation marks, so that it can be typed");
        }
    }

    private static Parameter explained(Parameter parameter) {
        return new Parameter(
                parameter.name(),
                parameter.kind(),
                parameter.unit(),
                parameter.range(),
                parameter.whole(),
                parameter.choices(),
                parameter.readable(),
                parameter.writable(),
                parameter.moves(),
                List.of(),
                ActDetails.oneLine(parameter.help().replace('"', '\'')));
    }

    private static Value fit(Parameter parameter, Value initial) {
        try {
            return parameter.fit(initial);
        } catch (RuntimeException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /** Returns the name. */
    public String name() {
        return parameter.name();
    }

    /** Returns whether a word is the name, in any case of its letters. */
    public boolean isNamed(String word) {
        return parameter.name().equalsIgnoreCase(word);
    }

    /**
     * Returns the message for a name that none of an act's arguments has.
     *
     * @param name the name as it was given
     * @param arguments all arguments of the act
     * @return what would be right, without full stop
     */
    public static String unknown(String name, List<ActArgument> arguments) {
        List<String> names = arguments.stream().map(ActArgument::name).toList();
        String takes = names.isEmpty() ? "it takes none" : "it takes " + String.join(", ", names);
        return name + ": the act has no such argument"
                + Suggestion.nearest(name, names)
                        .map(near -> "; did you mean " + near + "?")
                        .orElse("; " + takes);
    }

    /** Returns the default as it is typed: {@code 200mm/s}. */
    public String typed() {
        return typed(initial);
    }

    /**
     * Returns a value as it is typed, with all its digits.
     *
     * @param value a value of an argument
     * @return for instance {@code 200mm/s}, {@code on}, {@code left}; a text that is more than a word in quotation
     *     marks, since it could be read as a number
     */
    public static String typed(Value value) {
        if (value instanceof Value.Number number) {
            return plain(number.amount()) + number.unit().symbol();
        }
        String text = value.toString();
        return NAME.matcher(text).matches() ? text : '"' + text + '"';
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }

    /**
     * Reads an argument from the form that {@link #toString()} gives.
     *
     * @param text for instance {@code speed = 200mm/s from 50 to 400 "how fast it drives"}
     * @return the argument
     * @throws IllegalArgumentException if the text does not describe an argument, or the default is not permitted
     */
    public static ActArgument parse(String text) {
        Matcher parts = TEXT.matcher(text);
        if (!parts.matches()) {
            throw new IllegalArgumentException(
                    "'" + text + "' is not an argument, as in: speed = 200mm/s from 50 to 400 \"how fast it drives\"");
        }
        String name = parts.group("name");
        String help = parts.group("help");
        if (parts.group("number") != null) {
            return number(parts, name, help);
        }
        if (parts.group("text") != null) {
            return new ActArgument(Parameter.text(name, help), Value.text(parts.group("text")));
        }
        List<String> words = List.of(parts.group("words").split(" or "));
        return new ActArgument(Parameter.words(name, words, help), Value.text(words.get(0)));
    }

    private static ActArgument number(Matcher parts, String name, String help) {
        Unit unit = unit(parts.group("unit"));
        Parameter number = Parameter.number(name, unit, help)
                .within(bound(parts.group("from"), Range.ANY.min()), bound(parts.group("to"), Range.ANY.max()));
        return new ActArgument(
                parts.group("whole") == null ? number : number.inWholes(),
                Value.of(finite(parts.group("number")), unit));
    }

    /** Zero has no sign. */
    private static double finite(String text) {
        double number = Double.parseDouble(text) + 0.0;
        if (Double.isInfinite(number)) {
            throw new IllegalArgumentException("the number " + text + " is too large");
        }
        return number;
    }

    private static double bound(@Nullable String text, double otherwise) {
        return text == null ? otherwise : finite(text);
    }

    private static Unit unit(@Nullable String symbol) {
        return Arrays.stream(Unit.values())
                .filter(unit -> unit.symbol().equals(symbol == null ? "" : symbol))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no unit " + symbol));
    }

    /**
     * Returns the argument as it is written in an act's file and, without {@code whole}, in a script: {@code speed =
     * 200mm/s from 50 to 400 "how fast it drives"}.
     */
    @Override
    public String toString() {
        String value = switch (parameter.kind()) {
            case NUMBER, LIST -> typed() + (parameter.whole() ? " whole" : "") + bounds();
            case YES_NO, ON_OFF -> typed();
            case CHOICE -> String.join(" or ", initialFirst());
            case TEXT -> '"' + initial.toString() + '"';
        };
        return name() + " = " + value + " \"" + parameter.help() + '"';
    }

    private String bounds() {
        Range range = parameter.range();
        return (range.min() == Range.ANY.min() ? "" : " from " + plain(range.min()))
                + (range.max() == Range.ANY.max() ? "" : " to " + plain(range.max()));
    }

    private List<String> initialFirst() {
        List<String> words = new ArrayList<>(parameter.choices());
        words.remove(typed());
        words.add(0, typed());
        return words;
    }
}

package majicsim.aibo.urbi.value;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** A value of the language, printed as the kernel prints it (URBI sheet, section 4). Immutable. */
public sealed interface Value {
    /** The value and the text of {@code inf}. */
    double INFINITY = 999_999_999_999_999.0;

    /** No value. */
    Value VOID = new Void();

    /**
     * Its text in a reply; bytes are characters of the same number.
     *
     * @return without the line end; empty for no value
     */
    String print();

    /**
     * Its text in {@code echo}.
     *
     * @return without quotes, and with its backslash sequences resolved
     */
    default String show() {
        return print();
    }

    /**
     * Its text when {@code +} joins it to a string.
     *
     * @return without quotes; numbers with 6 significant digits
     */
    default String join() {
        return print();
    }

    /**
     * The size of its memory.
     *
     * @return bytes, approximately; a value that is twice in a list counts twice
     */
    default long weight() {
        return 16;
    }

    /**
     * Whether a test of it succeeds.
     *
     * @return true for numbers but 0
     */
    default boolean isTrue() {
        return false;
    }

    /**
     * Its number.
     *
     * @return the number
     * @throws Failure if it is none
     */
    default double number() throws Failure {
        throw Failure.inExpression();
    }

    /**
     * Its string.
     *
     * @return the text as it was written
     * @throws Failure if it is none
     */
    default String text() throws Failure {
        throw Failure.inExpression();
    }

    /**
     * A number.
     *
     * @param number any
     * @return the value
     */
    static Value of(double number) {
        return new Num(number);
    }

    /**
     * A truth value, which is a number here.
     *
     * @param truth true for 1
     * @return the value
     */
    static Value of(boolean truth) {
        return new Num(truth ? 1 : 0);
    }

    /**
     * A text.
     *
     * @param text as it is written between quotes
     * @return the value
     */
    static Value of(String text) {
        return new Text(text);
    }

    /**
     * A number, printed with six decimals always, never with an exponent.
     *
     * @param number any
     */
    record Num(double number) implements Value {
        @Override
        public String print() {
            if (Double.isNaN(number)) {
                return "nan";
            }
            if (Double.isInfinite(number)) {
                return number > 0 ? "inf" : "-inf";
            }
            return Decimals.six(number);
        }

        @Override
        public String join() {
            if (Double.isNaN(number) || Double.isInfinite(number)) {
                return print();
            }
            BigDecimal six = new BigDecimal(number).round(new MathContext(6, RoundingMode.HALF_EVEN));
            int exponent = six.signum() == 0 ? 0 : six.precision() - six.scale() - 1;
            if (exponent >= -4 && exponent < 6) {
                return six.signum() == 0 ? "0" : six.stripTrailingZeros().toPlainString();
            }
            BigDecimal mantissa = six.movePointLeft(exponent).stripTrailingZeros();
            return mantissa.toPlainString() + String.format(Locale.ROOT, "e%+03d", exponent);
        }

        @Override
        public boolean isTrue() {
            return number != 0;
        }
    }

    /**
     * A string; its backslash sequences are resolved by echo alone.
     *
     * @param text as it was written
     */
    record Text(String text) implements Value {
        @Override
        public long weight() {
            return text.length();
        }

        @Override
        public String print() {
            return '"' + text + '"';
        }

        @Override
        public String show() {
            return text.replace("\\n", "\n")
                    .replace("\\t", "\t")
                    .replace("\\\"", "\"")
                    .replace("\\\\", "\\");
        }

        @Override
        public String join() {
            return text;
        }
    }

    /**
     * A list.
     *
     * @param items in order
     */
    record Items(List<Value> items) implements Value {
        /** Keeps a copy. */
        public Items {
            items = List.copyOf(items);
        }

        @Override
        public long weight() {
            return 16 + items.stream().mapToLong(Value::weight).sum();
        }

        Items plus(Value added) {
            List<Value> longer = new ArrayList<>(items);
            longer.add(added);
            return new Items(longer);
        }

        @Override
        public String print() {
            return "[" + String.join(",", items.stream().map(Value::print).toList()) + "]";
        }
    }

    /**
     * Bytes with the words that describe them.
     *
     * @param bytes as characters of the same number
     * @param parameters such as {@code jpeg 208 160}; may be empty
     */
    record Binary(String bytes, String parameters) implements Value {
        @Override
        public long weight() {
            return bytes.length();
        }

        @Override
        public String print() {
            String header = "BIN " + bytes.length() + (parameters.isEmpty() ? "" : " " + parameters);
            return header + "\n" + bytes;
        }
    }

    /**
     * An object of a program.
     *
     * @param fields by their names
     */
    record Obj(Map<String, Value> fields) implements Value {
        @Override
        public String print() {
            return fields.entrySet().stream()
                    .map(field -> field.getKey() + ":" + field.getValue().print())
                    .collect(Collectors.joining(",", "OBJ [", "]"));
        }
    }

    /** No value: a declared variable, or what a function without return gives. */
    record Void() implements Value {
        @Override
        public String print() {
            return "";
        }
    }
}

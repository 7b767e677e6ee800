package majicsim.aibo;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** A value of the language, printed as the kernel prints it (URBI sheet, section 4). Immutable. */
sealed interface Value {
    /** What {@code inf} stands for and prints as. */
    double INFINITY = 999_999_999_999_999.0;

    Value VOID = new Void();

    /** As a reply prints it; bytes stand as characters of the same number. */
    String print();

    /** As {@code echo} shows it. */
    default String show() {
        return print();
    }

    /** As it is joined to a string by {@code +}. */
    default String join() {
        return print();
    }

    /** The memory that it takes, about that many bytes; what a list holds twice counts twice. */
    default long weight() {
        return 16;
    }

    /** Whether a test of it succeeds. */
    default boolean isTrue() {
        return false;
    }

    static Value of(double number) {
        return new Num(number);
    }

    static Value of(boolean truth) {
        return new Num(truth ? 1 : 0);
    }

    static Value of(String text) {
        return new Text(text);
    }

    /** A number: always six decimals, never an exponent. */
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

    /** A string, kept as it was written: its backslash sequences are resolved by echo alone. */
    record Text(String raw) implements Value {
        @Override
        public long weight() {
            return raw.length();
        }

        @Override
        public String print() {
            return '"' + raw + '"';
        }

        @Override
        public String show() {
            return raw.replace("\\n", "\n")
                    .replace("\\t", "\t")
                    .replace("\\\"", "\"")
                    .replace("\\\\", "\\");
        }

        @Override
        public String join() {
            return raw;
        }
    }

    /** A list. */
    record Items(List<Value> items) implements Value {
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

    /** Bytes with the words that describe them, such as {@code jpeg 208 160}. */
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

    /** An object of a program with its fields. */
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

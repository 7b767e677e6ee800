package majic.script.syntax;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import majic.bot.Unit;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/**
 * Computes with values. A bare number takes the unit of the other one when both are added or compared. {@code clear}
 * stays clear whatever is added, taken away or multiplied, and is greater than any number. Estimates make estimates.
 * The methods throw a {@link ScriptException} at the sign if the values do not go together.
 */
final class Arithmetic {
    /** A product of units: the unit of the first times that of the second one. */
    private record Product(Unit first, Unit second, Unit result) {}

    private static final List<Product> PRODUCTS = List.of(
            new Product(Unit.MM_PER_S, Unit.S, Unit.MM),
            new Product(Unit.DEG_PER_S, Unit.S, Unit.DEG),
            new Product(Unit.MM_PER_S2, Unit.S, Unit.MM_PER_S),
            new Product(Unit.DEG_PER_S2, Unit.S, Unit.DEG_PER_S));

    private Arithmetic() {}

    static Operand add(Operand left, Operand right, Token sign) {
        return alike(left, right, sign, "added", Double::sum);
    }

    static Operand subtract(Operand left, Operand right, Token sign) {
        if (right.value() instanceof Value.Clear) {
            throw new ScriptException(sign, sign.text() + ": clear, nothing in range, cannot be subtracted");
        }
        return alike(left, right, sign, "subtracted", (first, second) -> first - second);
    }

    static Operand least(Operand left, Operand right, Token name) {
        if (left.value() instanceof Value.Clear || right.value() instanceof Value.Clear) {
            return left.value() instanceof Value.Clear ? right : left;
        }
        return alike(left, right, name, "compared", Math::min);
    }

    static Operand greatest(Operand left, Operand right, Token name) {
        return alike(left, right, name, "compared", Math::max);
    }

    static Operand negate(Operand operand, Token sign) {
        if (operand.value() instanceof Value.Clear) {
            throw new ScriptException(sign, sign.text() + ": clear, nothing in range, has no opposite");
        }
        return alone(operand, sign, number -> -number);
    }

    static Operand absolute(Operand operand, Token name) {
        return alone(operand, name, Math::abs);
    }

    static Operand multiply(Operand left, Operand right, Token sign) {
        Operand special = unknownOrClear(left, right, sign);
        return special == null
                ? number(left, right, product(left, right, sign), sign, (first, second) -> first * second)
                : special;
    }

    static Operand divide(Operand left, Operand right, Token sign) {
        if (right.value() instanceof Value.Clear) {
            throw new ScriptException(sign, sign.text() + ": clear, nothing in range, cannot divide");
        }
        Operand special = unknownOrClear(left, right, sign);
        if (special != null) {
            return special;
        }
        if (!right.open() && right.value().number() == 0) {
            throw new ScriptException(sign, sign.text() + ": nothing can be divided by 0");
        }
        Unit unit = quotient(left, right, sign);
        return left.open() || right.open()
                ? Operand.open(unit)
                : number(left, right, unit, sign, (first, second) -> first / second);
    }

    /** A random number between two, whole if both are. */
    static Operand random(Operand from, Operand to, Token name, double share) {
        return alike(from, to, name, "compared", (low, high) -> {
            boolean whole = low == Math.rint(low) && high == Math.rint(high);
            return whole ? low + Math.floor(share * (high - low + 1)) : low + share * (high - low);
        });
    }

    private static Operand alone(Operand operand, Token sign, DoubleUnaryOperator rule) {
        if (operand.any() || operand.value() instanceof Value.Clear) {
            return operand;
        }
        requireNumber(operand, sign);
        Value.Number number = (Value.Number) operand.value();
        return new Operand(
                new Value.Number(rule.applyAsDouble(number.amount()), number.unit(), number.about()),
                operand.open(),
                false);
    }

    private static Operand alike(Operand left, Operand right, Token sign, String what, DoubleBinaryOperator rule) {
        Operand special = unknownOrClear(left, right, sign);
        if (special != null) {
            return special;
        }
        if (left.unit() != right.unit() && left.unit() != Unit.NONE && right.unit() != Unit.NONE) {
            throw new ScriptException(
                    sign,
                    sign.text() + ": " + left.unit().symbol() + " and "
                            + right.unit().symbol() + " cannot be " + what);
        }
        return number(left, right, left.unit() == Unit.NONE ? right.unit() : left.unit(), sign, rule);
    }

    /** What comes of values of which one is not known at all, or is clear; null for two numbers. */
    private static @Nullable Operand unknownOrClear(Operand left, Operand right, Token sign) {
        for (Operand one : List.of(left, right)) {
            if (!one.any() && !(one.value() instanceof Value.Clear)) {
                requireNumber(one, sign);
            }
        }
        if (left.value() instanceof Value.Clear || right.value() instanceof Value.Clear) {
            return Operand.of(Value.CLEAR);
        }
        return left.any() || right.any() ? Operand.ANY : null;
    }

    private static void requireNumber(Operand operand, Token sign) {
        if (!operand.isNumber()) {
            throw new ScriptException(sign, sign.text() + ": " + operand.kind() + " is not a number");
        }
    }

    private static Operand number(Operand left, Operand right, Unit unit, Token sign, DoubleBinaryOperator rule) {
        Value.Number first = (Value.Number) left.value();
        Value.Number second = (Value.Number) right.value();
        double amount = rule.applyAsDouble(first.amount(), second.amount());
        if (!Double.isFinite(amount)) {
            throw new ScriptException(sign, sign.text() + ": too large a number comes of it");
        }
        return new Operand(
                new Value.Number(amount, unit, first.about() || second.about()), left.open() || right.open(), false);
    }

    private static Unit product(Operand left, Operand right, Token sign) {
        Unit first = left.unit();
        Unit second = right.unit();
        if (first == Unit.NONE || second == Unit.NONE) {
            return first == Unit.NONE ? second : first;
        }
        return PRODUCTS.stream()
                .filter(known -> (known.first == first && known.second == second)
                        || (known.first == second && known.second == first))
                .map(Product::result)
                .findFirst()
                .orElseThrow(() -> new ScriptException(
                        sign, sign.text() + ": " + first.symbol() + " times " + second.symbol() + " has no unit here"));
    }

    private static Unit quotient(Operand left, Operand right, Token sign) {
        Unit first = left.unit();
        Unit second = right.unit();
        if (second == Unit.NONE || first == second) {
            return first == second ? Unit.NONE : first;
        }
        return PRODUCTS.stream()
                .filter(known -> known.result == first && (known.first == second || known.second == second))
                .map(known -> known.first == second ? known.second : known.first)
                .findFirst()
                .orElseThrow(() -> new ScriptException(
                        sign,
                        sign.text() + ": " + (first == Unit.NONE ? "a bare number" : first.symbol()) + " divided by "
                                + second.symbol() + " has no unit here"));
    }
}

package majicsim.aibo.urbi;

import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.function.DoubleUnaryOperator;
import majicsim.aibo.urbi.run.Functions;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import majicsim.world.Noise;

/** The functions of the language that need no hardware (URBI sheet, section 5). */
final class BuiltIns {
    private BuiltIns() {}

    static void install(Functions functions, Noise noise, DoubleSupplier timestampMs) {
        mathematics(functions);
        strings(functions);
        lists(functions);
        functions.builtIn("time", arguments -> Value.of(timestampMs.getAsDouble()));
        functions.builtIn("cpuload", arguments -> Value.of(0.12));
        functions.builtIn("freemem", arguments -> Value.of(19_000_000));
        functions.builtIn("random", arguments -> random(number(arguments, 0), noise));
        // The evaluator computes these two itself when their argument is a name; for anything else they are true and
        // false.
        functions.builtIn("isdef", arguments -> Value.of(true));
        functions.builtIn("isvoid", arguments -> Value.of(argument(arguments, 0) instanceof Value.Void));
        functions.builtIn("atan2", arguments -> Value.of(Math.atan2(number(arguments, 0), number(arguments, 1))));
    }

    private static void mathematics(Functions functions) {
        real(functions, "sin", Math::sin);
        real(functions, "cos", Math::cos);
        real(functions, "tan", Math::tan);
        real(functions, "asin", Math::asin);
        real(functions, "acos", Math::acos);
        real(functions, "atan", Math::atan);
        real(functions, "exp", Math::exp);
        real(functions, "log", Math::log);
        real(functions, "abs", Math::abs);
        real(functions, "sgn", Math::signum);
        real(functions, "round", Math::round);
        real(functions, "trunc", x -> x < 0 ? Math.ceil(x) : Math.floor(x));
        functions.builtIn("sqrt", arguments -> {
            double x = number(arguments, 0);
            if (x < 0) {
                throw Failure.inExpression("Negative square root");
            }
            return Value.of(Math.sqrt(x));
        });
    }

    private static void real(Functions functions, String name, DoubleUnaryOperator function) {
        functions.builtIn(name, arguments -> Value.of(function.applyAsDouble(number(arguments, 0))));
    }

    private static void strings(Functions functions) {
        functions.builtIn("string", arguments -> {
            Value value = argument(arguments, 0);
            return Value.of(value instanceof Value.Num num ? Long.toString((long) num.number()) : value.join());
        });
        // One too many: the real kernel counts the terminating zero (capture C).
        functions.builtIn(
                "strlen", arguments -> Value.of(argument(arguments, 0).text().length() + 1.0));
        functions.builtIn("strsub", arguments -> {
            String text = argument(arguments, 0).text();
            int from = (int) Math.max(0, Math.min(text.length(), number(arguments, 1)));
            int end = (int) Math.max(from, Math.min(text.length(), from + number(arguments, 2)));
            return Value.of(text.substring(from, end));
        });
    }

    private static void lists(Functions functions) {
        functions.builtIn("head", arguments -> {
            List<Value> items = items(arguments);
            return items.isEmpty() ? Value.VOID : items.get(0);
        });
        functions.builtIn("tail", arguments -> {
            List<Value> items = items(arguments);
            return new Value.Items(items.isEmpty() ? items : items.subList(1, items.size()));
        });
        functions.builtIn("size", arguments -> Value.of(items(arguments).size()));
        functions.builtIn("getIndex", arguments -> {
            int index = (int) number(arguments, 1);
            List<Value> items = items(arguments);
            if (index < 0 || index >= items.size()) {
                throw Failure.inExpression();
            }
            return items.get(index);
        });
    }

    private static Value random(double limit, Noise noise) {
        return Value.of(limit < 1 ? 0 : Math.floor(noise.uniform(0, limit)));
    }

    private static Value argument(List<Value> arguments, int index) throws Failure {
        if (index >= arguments.size()) {
            throw Failure.inExpression();
        }
        return arguments.get(index);
    }

    private static double number(List<Value> arguments, int index) throws Failure {
        return argument(arguments, index).number();
    }

    private static List<Value> items(List<Value> arguments) throws Failure {
        if (argument(arguments, 0) instanceof Value.Items list) {
            return list.items();
        }
        throw Failure.inExpression();
    }
}

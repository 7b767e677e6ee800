package majicsim.aibo.urbi.value;

/** The operators on values (URBI sheet, section 5). */
public final class Operators {
    private static final double EPSILON = 0.0001;

    private Operators() {}

    public static Value apply(String operator, Value left, Value right) throws Failure {
        return switch (operator) {
            case "+" -> plus(left, right);
            case "&&" -> Value.of(left.isTrue() && right.isTrue());
            case "||" -> Value.of(left.isTrue() || right.isTrue());
            case "==" -> Value.of(left.equals(right));
            case "!=" -> Value.of(!left.equals(right));
            case "~=", "=~=", "%=", "<", "<=", ">", ">=" -> Value.of(compare(operator, left.number(), right.number()));
            default -> Value.of(calculate(operator, left.number(), right.number()));
        };
    }

    private static Value plus(Value left, Value right) throws Failure {
        if (left instanceof Value.Items list) {
            return MemoryLimits.checked(list.plus(right));
        }
        if (left instanceof Value.Text || right instanceof Value.Text) {
            return MemoryLimits.checked(Value.of(left.join() + right.join()));
        }
        return Value.of(left.number() + right.number());
    }

    private static boolean compare(String operator, double left, double right) {
        return switch (operator) {
            case "<" -> left < right;
            case "<=" -> left <= right;
            case ">" -> left > right;
            case ">=" -> left >= right;
            case "%=" -> right != 0 && Math.abs(1 - left / right) < EPSILON;
            default -> Math.abs(left - right) <= EPSILON;
        };
    }

    private static double calculate(String operator, double left, double right) throws Failure {
        return switch (operator) {
            case "-" -> left - right;
            case "*" -> left * right;
            case "/" -> left / nonZero(right);
            case "%" -> left % nonZero(right);
            default -> Math.pow(left, right);
        };
    }

    private static double nonZero(double divisor) throws Failure {
        if (divisor == 0) {
            throw Failure.inExpression("Division by zero");
        }
        return divisor;
    }
}

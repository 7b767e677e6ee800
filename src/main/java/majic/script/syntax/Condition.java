package majic.script.syntax;

import org.jspecify.annotations.Nullable;

/** What {@code until}, {@code while} and {@code if} test. {@code toString()} returns it as answers repeat it. */
public sealed interface Condition {
    <R> R accept(Visitor<R> visitor);

    /** One method for each kind of condition. */
    interface Visitor<R> {
        R or(Or or);

        R and(And and);

        R not(Not not);

        R comparison(Comparison comparison);

        R known(Known known);
    }

    /** True if one of two conditions is. */
    record Or(Condition left, Condition right) implements Condition {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.or(this);
        }

        @Override
        public String toString() {
            return left + " or " + right;
        }
    }

    /** True if both conditions are. */
    record And(Condition left, Condition right) implements Condition {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.and(this);
        }

        @Override
        public String toString() {
            return bracketed(left) + " and " + bracketed(right);
        }
    }

    /** True if a condition is not. */
    record Not(Condition inner) implements Condition {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.not(this);
        }

        @Override
        public String toString() {
            return inner instanceof Comparison || inner instanceof Known ? "not " + inner : "not (" + inner + ")";
        }
    }

    /** A parameter compared with a value; without robots it is the parameter of the command's robot. */
    record Comparison(@Nullable Robots robots, Token parameter, Operator operator, Literal value) implements Condition {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.comparison(this);
        }

        @Override
        public String toString() {
            String what = parameter.text() + " " + operator + " " + value.text();
            return robots == null ? what : robots.text() + " " + what;
        }
    }

    /** A value compared with another one; both were computed when the line was parsed. */
    record Known(Literal left, Operator operator, Literal right) implements Condition {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.known(this);
        }

        @Override
        public String toString() {
            boolean isWord = left.at().kind() == Token.Kind.WORD;
            return (isWord ? '"' + left.text() + '"' : left.text()) + " " + operator + " " + right.text();
        }
    }

    private static String bracketed(Condition part) {
        return part instanceof Or ? "(" + part + ")" : part.toString();
    }
}

package majicsim.aibo.urbi;

import java.util.List;

/** What can be evaluated to a value. */
sealed interface Expr {
    /** Its value; every call to a function that takes time must have been made before. */
    Value value(Evaluator evaluator) throws Failure;

    /** The expressions directly inside this one. */
    default List<Expr> parts() {
        return List.of();
    }

    /** Whether its value is the same whenever it is asked for. */
    default boolean isConstant() {
        return !parts().isEmpty() && parts().stream().allMatch(Expr::isConstant);
    }

    /** A number, a time or a string as written. */
    record Constant(Value value) implements Expr {
        @Override
        public boolean isConstant() {
            return true;
        }

        @Override
        public Value value(Evaluator evaluator) {
            return value;
        }
    }

    /** A variable or a device's field; a static one keeps the value with which a command read it first. */
    record Variable(Name name, boolean isStatic) implements Expr {
        Variable(Name name) {
            this(name, false);
        }

        @Override
        public boolean isConstant() {
            return false;
        }

        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return isStatic ? evaluator.fixed(this) : evaluator.variable(name);
        }

        @Override
        public List<Expr> parts() {
            return name.index();
        }
    }

    /** A property of a variable, {@code x->rangemin}. */
    record Property(Name name, String property) implements Expr {
        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return evaluator.property(this);
        }
    }

    /** A list. */
    record Items(List<Expr> parts) implements Expr {
        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return evaluator.items(this);
        }
    }

    /** The members of a group, {@code group g}. */
    record Members(String group) implements Expr {
        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return evaluator.members(group);
        }
    }

    /** An operator between two expressions. */
    record Binary(String operator, Expr left, Expr right) implements Expr {
        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return evaluator.binary(this);
        }

        @Override
        public List<Expr> parts() {
            return List.of(left, right);
        }
    }

    /** Minus or not. */
    record Unary(String operator, Expr operand) implements Expr {
        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return evaluator.unary(this);
        }

        @Override
        public List<Expr> parts() {
            return List.of(operand);
        }
    }

    /** A function call. Two calls that read alike are still two: they are told apart by identity. */
    record Call(Name function, List<Expr> parts) implements Expr {
        @Override
        public boolean isConstant() {
            return false;
        }

        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return evaluator.call(this);
        }
    }

    /** A test that counts only when it has held for a time, {@code test ~ 2s}. */
    record Soft(Expr test, Expr holdMs) implements Expr {
        @Override
        public Value value(Evaluator evaluator) throws Failure {
            return test.value(evaluator);
        }

        @Override
        public List<Expr> parts() {
            return List.of(test, holdMs);
        }
    }
}

package majicsim.aibo.urbi.syntax;

import java.util.List;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/** What can be evaluated to a value. */
public sealed interface Expr {
    /** What an expression needs to have a value: one method for each kind that is not its own value. */
    interface Evaluation {
        Value fixed(Variable variable) throws Failure;

        Value variable(Name name) throws Failure;

        Value property(Property property) throws Failure;

        Value items(Items list) throws Failure;

        Value members(String group) throws Failure;

        Value binary(Binary binary) throws Failure;

        Value unary(Unary unary) throws Failure;

        Value call(Call call) throws Failure;
    }

    /** Its value; every call to a function that takes time must have been made before. */
    Value value(Evaluation evaluation) throws Failure;

    /** The expressions directly inside this one. */
    default List<Expr> parts() {
        return List.of();
    }

    /** Whether its value is always the same. */
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
        public Value value(Evaluation evaluation) {
            return value;
        }
    }

    /** A variable or a device's field; a static one keeps the value with which a command read it first. */
    record Variable(Name name, boolean isStatic) implements Expr {
        public Variable(Name name) {
            this(name, false);
        }

        @Override
        public boolean isConstant() {
            return false;
        }

        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return isStatic ? evaluation.fixed(this) : evaluation.variable(name);
        }

        @Override
        public List<Expr> parts() {
            return name.index();
        }
    }

    /** A property of a variable, {@code x->rangemin}. */
    record Property(Name name, String property) implements Expr {
        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return evaluation.property(this);
        }
    }

    /** A list. */
    record Items(List<Expr> parts) implements Expr {
        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return evaluation.items(this);
        }
    }

    /** The members of a group, {@code group g}. */
    record Members(String group) implements Expr {
        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return evaluation.members(group);
        }
    }

    /** An operator between two expressions. */
    record Binary(String operator, Expr left, Expr right) implements Expr {
        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return evaluation.binary(this);
        }

        @Override
        public List<Expr> parts() {
            return List.of(left, right);
        }
    }

    /** Minus or not. */
    record Unary(String operator, Expr operand) implements Expr {
        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return evaluation.unary(this);
        }

        @Override
        public List<Expr> parts() {
            return List.of(operand);
        }
    }

    /** A function call. Calls are compared by identity: two with the same text are still two. */
    record Call(Name function, List<Expr> parts) implements Expr {
        @Override
        public boolean isConstant() {
            return false;
        }

        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return evaluation.call(this);
        }
    }

    /** A test that counts only when it has held for a time, {@code test ~ 2s}. */
    record Soft(Expr test, Expr holdMs) implements Expr {
        @Override
        public Value value(Evaluation evaluation) throws Failure {
            return test.value(evaluation);
        }

        @Override
        public List<Expr> parts() {
            return List.of(test, holdMs);
        }
    }
}

package majicsim.aibo.urbi.syntax;

import java.util.List;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** A command with one effect: an answer, an assignment, a command to the server (URBI sheet, sections 5 to 9). */
public sealed interface Action extends Statement {
    /**
     * One method for each kind of these commands.
     *
     * @param <R> the visitor's result
     */
    interface Visitor<R> {
        R evaluate(Evaluate command);

        R assign(Assign command);

        R change(Change command);

        R assignProperty(AssignProperty command);

        R assignBinary(AssignBinary command);

        R power(Power command);

        R control(Control command);

        R reach(Reach command);

        R echo(Echo command);

        R command(Command command);
    }

    /** An expression, whose value is the reply. */
    record Evaluate(Expr expr) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.evaluate(this);
        }
    }

    /** An assignment with its modifiers. */
    record Assign(Name target, Expr value, List<Modifier> modifiers, boolean declares) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.assign(this);
        }

        /** The same for another variable. */
        public Assign to(Name other) {
            return new Assign(other, value, modifiers, declares);
        }
    }

    /** {@code x += v}, {@code x -= v}, {@code x++}, {@code x--}: sign is 1 or -1. */
    record Change(Name target, int sign, Expr amount) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.change(this);
        }
    }

    /** {@code x->rangemin = v}. */
    record AssignProperty(Name target, String property, Expr value) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.assignProperty(this);
        }

        /** The same for another variable. */
        public AssignProperty to(Name other) {
            return new AssignProperty(other, property, value);
        }
    }

    /** {@code x = bin 5 wav;}, whose bytes follow the command; it can run only when they are filled in. */
    record AssignBinary(Name target, int size, String parameters) implements Action {
        public Statement filled(String bytes) {
            return new Assign(target, new Expr.Constant(new Value.Binary(bytes, parameters)), List.of(), false);
        }

        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.assignBinary(this);
        }
    }

    /** {@code dev on}, {@code dev off}, {@code dev switch} (null). */
    record Power(Name device, @Nullable Double load) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.power(this);
        }
    }

    /** {@code stop}, {@code freeze}, {@code unfreeze}, {@code block}, {@code unblock} with a tag. */
    record Control(String word, String tag) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.control(this);
        }
    }

    /** {@code disconnect} or {@code killall} with a connection's name. */
    record Reach(String word, String connection) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.reach(this);
        }
    }

    /** {@code echo}. */
    record Echo(Expr value, List<Modifier> options) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.echo(this);
        }
    }

    /** A command that is a single word, such as {@code ping}. */
    record Command(String word) implements Action {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.command(this);
        }
    }
}

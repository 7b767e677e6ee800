package majicsim.aibo.urbi.syntax;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A command that defines a name or removes it (URBI sheet, section 10). */
public sealed interface Definition extends Statement {
    /**
     * One method for each kind of these commands.
     *
     * @param <R> the visitor's result
     */
    interface Visitor<R> {
        R declare(Declare command);

        R define(Define command);

        R undefine(Undefine command);

        R group(Grouping command);

        R alias(Alias command);

        R event(Event command);

        R classOf(ClassOf command);

        R create(New command);
    }

    /** {@code var x}. */
    record Declare(Name target) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.declare(this);
        }
    }

    /** A function's definition. */
    record Define(Name function, List<String> parameters, Statement body) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.define(this);
        }
    }

    /** {@code undef x}. */
    record Undefine(Name name) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.undefine(this);
        }
    }

    /** {@code group g {a, b}}, {@code addgroup}, {@code delgroup}. */
    record Grouping(String word, String group, List<String> members) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.group(this);
        }
    }

    /** {@code alias a b}, and {@code unalias a} (null). */
    record Alias(String name, @Nullable String meaning) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.alias(this);
        }
    }

    /** {@code event e}. */
    record Event(Name name, boolean hasParameters) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.event(this);
        }
    }

    /** {@code class C { var v; function f(); event e }}; its functions are defined apart. */
    record ClassOf(String name, List<String> variables, List<String> events) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.classOf(this);
        }
    }

    /** {@code object = new parent}, with its constructor called if brackets follow. */
    record New(Name object, String parent, boolean constructs, List<Expr> arguments) implements Definition {
        @Override
        public <R> R accept(Statement.Visitor<R> visitor) {
            return visitor.create(this);
        }
    }
}

package majicsim.aibo.urbi;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A command that makes a name known or forgets it (URBI sheet, section 10). */
sealed interface Definition extends Statement {
    /** {@code var x}. */
    record Declare(Name target) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.declare(context, target));
        }
    }

    /** A function's definition. */
    record Define(Name function, List<String> parameters, Statement body) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.function(context, this));
        }
    }

    /** {@code undef x}. */
    record Undefine(Name name) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.undefine(context, name));
        }
    }

    /** {@code group g {a, b}}, {@code addgroup}, {@code delgroup}. */
    record Grouping(String word, String group, List<String> members) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.group(context, this));
        }
    }

    /** {@code alias a b}, and {@code unalias a} (null). */
    record Alias(String name, @Nullable String meaning) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.alias(context, this));
        }
    }

    /** {@code event e}. */
    record Event(Name name, boolean hasParameters) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.event(context, this));
        }
    }

    /** {@code class C { var v; function f(); event e }}; its functions are defined apart. */
    record ClassOf(String name, List<String> variables, List<String> events) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Definitions.classOf(context, this));
        }
    }

    /** {@code object = new parent}, with its constructor called if brackets follow. */
    record New(Name object, String parent, boolean constructs, List<Expr> arguments) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, arguments, values -> Creation.start(context, this, values));
        }
    }
}

package majicsim.aibo;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A command that makes a name known or forgets it (URBI sheet, section 10). */
sealed interface Definition extends Statement {
    /** {@code var x}. */
    record Declare(Name target) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.declare(context, target));
        }
    }

    /** A function's definition. */
    record Define(Name function, List<String> parameters, Statement body) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.define(context, this));
        }
    }

    /** {@code undef x}. */
    record Undefine(Name name) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.undefine(context, name));
        }
    }

    /** {@code group g {a, b}}, {@code addgroup}, {@code delgroup}. */
    record Grouping(String word, String group, List<String> members) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.group(context, this));
        }
    }

    /** {@code alias a b}, and {@code unalias a} (null). */
    record Alias(String name, @Nullable String meaning) implements Definition {
        @Override
        public Task start(Context context) {
            return new Prepared(context, List.of(), values -> Effects.alias(context, this));
        }
    }
}

package majicsim.aibo.urbi;

import java.util.List;

/** A command of the language, as the parser understood it; the kinds that hold others together stand here. */
sealed interface Statement
        permits Action,
                Definition,
                Flow,
                Statement.Empty,
                Statement.Tagged,
                Statement.Block,
                Statement.Both,
                Statement.Then {
    /** A new run of this command; nothing happens before its first step. */
    Task start(Context context);

    /** Nothing, as between two semicolons. */
    record Empty() implements Statement {
        @Override
        public Task start(Context context) {
            return Task.done(context);
        }
    }

    /** A command with its tag ({@code notag} if it has none) and flags. */
    record Tagged(String tag, List<Flag> flags, Statement body) implements Statement {
        @Override
        public Task start(Context context) {
            return Flag.in(flags, "connection")
                    ? Delegation.start(context.inner(tag), this)
                    : new TaggedTask(context.inner(tag, flags), flags, body);
        }
    }

    /** {@code { … }}. */
    record Block(List<Step> steps) implements Statement {
        @Override
        public Task start(Context context) {
            return new CommandStream(context, steps);
        }
    }

    /** {@code a & b}. */
    record Both(Statement left, Statement right) implements Statement {
        @Override
        public Task start(Context context) {
            return new BothTask(context, left, right);
        }
    }

    /** {@code a | b}. */
    record Then(Statement left, Statement right) implements Statement {
        @Override
        public Task start(Context context) {
            return new ThenTask(context, left, right);
        }
    }
}

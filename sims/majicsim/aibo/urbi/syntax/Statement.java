package majicsim.aibo.urbi.syntax;

import java.util.List;

/**
 * A command of the language as the parser read it; the kinds that contain other commands are declared here. A statement
 * does not run by itself; a {@link Visitor} executes it.
 */
public sealed interface Statement
        permits Action,
                Definition,
                Flow,
                Statement.Empty,
                Statement.Tagged,
                Statement.Block,
                Statement.Both,
                Statement.Then {
    /** The tag of a command that has none. */
    String NO_TAG = "notag";

    /**
     * One method for each kind of command.
     *
     * @param <R> the visitor's result
     */
    interface Visitor<R> extends Action.Visitor<R>, Flow.Visitor<R>, Definition.Visitor<R> {
        R empty(Empty command);

        R tagged(Tagged command);

        R block(Block command);

        R both(Both command);

        R then(Then command);
    }

    /** Calls the visitor's method for this kind of command. */
    <R> R accept(Visitor<R> visitor);

    /** Nothing, as between two semicolons. */
    record Empty() implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.empty(this);
        }
    }

    /** A command with its tag ({@link #NO_TAG} if it has none) and flags. */
    record Tagged(String tag, List<Flag> flags, Statement body) implements Statement {
        /** The command inside the conditions of its obsolete flags, which still have an effect. */
        public Statement conditional() {
            Statement conditional = body;
            for (Flag flag : flags) {
                String word = flag.successor();
                if (word != null && flag.argument() != null) {
                    conditional = new Flow.Watched(word, flag.argument(), conditional);
                }
            }
            return conditional;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.tagged(this);
        }
    }

    /** {@code { … }}. */
    record Block(List<SeparatedStatement> steps) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.block(this);
        }
    }

    /** {@code a & b}. */
    record Both(Statement left, Statement right) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.both(this);
        }
    }

    /** {@code a | b}. */
    record Then(Statement left, Statement right) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.then(this);
        }
    }
}

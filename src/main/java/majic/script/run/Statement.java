package majic.script.run;

import java.util.List;
import java.util.OptionalInt;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.script.syntax.Condition;
import majic.script.syntax.Robots;
import majic.script.syntax.Token;

/** One command, or a block of them. */
public sealed interface Statement {
    /** Where it begins. */
    Token at();

    <R> R accept(Visitor<R> visitor);

    /** When it runs, seen from the lines before and behind it; a block beside the lines that follow. */
    default Scheduling scheduling() {
        return Scheduling.BESIDE;
    }

    /** Whether it has other statements in it. */
    default boolean isBlock() {
        return false;
    }

    /** One method for each kind of statement. */
    interface Visitor<R> {
        R repeat(Repeat repeat);

        R whileLoop(While loop);

        R choice(If choice);

        R forRobots(ForRobots command);

        R forSession(ForSession command);

        R argument(Argument argument);
    }

    /**
     * Describes an argument of the script, and its value if none is given; does nothing.
     *
     * @param parameter its name, unit, range and explanation
     * @param initial in the form that the parameter takes
     */
    record Argument(Token at, Parameter parameter, Value initial) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.argument(this);
        }
    }

    /** Repeats its body; for ever without a number of times. */
    record Repeat(Token at, OptionalInt times, List<Statement> body) implements Statement {
        @Override
        public boolean isBlock() {
            return true;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.repeat(this);
        }
    }

    /** Repeats its body as long as a condition holds. */
    record While(Token at, Condition condition, List<Statement> body) implements Statement {
        @Override
        public boolean isBlock() {
            return true;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.whileLoop(this);
        }
    }

    /** Runs one of two bodies. */
    record If(Token at, Condition condition, List<Statement> body, List<Statement> otherwise) implements Statement {
        @Override
        public boolean isBlock() {
            return true;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.choice(this);
        }
    }

    /** One command for robots. */
    record ForRobots(Token at, Robots robots, Command command) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.forRobots(this);
        }

        @Override
        public Scheduling scheduling() {
            return command.scheduling();
        }
    }

    /** One command for the session. */
    record ForSession(Token at, SessionCommand command) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.forSession(this);
        }

        @Override
        public Scheduling scheduling() {
            return command.scheduling();
        }
    }
}

package majic.script.run;

import java.util.List;
import java.util.OptionalInt;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.script.syntax.Condition;
import majic.script.syntax.Late;
import majic.script.syntax.Literal;
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

        R computed(Computed line);

        R on(On on);

        R procedure(ProcedureDefinition definition);

        R call(Call call);
    }

    /**
     * Describes an argument of the script, and its value if none is given; does nothing.
     *
     * @param name as it was written
     * @param parameter its name, unit, range and explanation
     * @param initial in the form that the parameter takes
     * @param value what it has in this run
     */
    record Argument(Token at, Token name, Parameter parameter, Value initial, Value value) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.argument(this);
        }
    }

    /** Repeats its body; for ever without a number of times. */
    record Repeat(Token at, Late<OptionalInt> times, List<Statement> body) implements Statement {
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
    record While(Token at, Late<Condition> condition, List<Statement> body) implements Statement {
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
    record If(Token at, Late<Condition> condition, List<Statement> body, List<Statement> otherwise)
            implements Statement {
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

    /** One command with a value in it that is computed when the line runs. */
    record Computed(Token at, Late<Statement> line) implements Statement {
        @Override
        public boolean isBlock() {
            return line.sample().isBlock();
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.computed(this);
        }

        /** A robot may have to be asked, so a line that reads one does not run on the thread of a user. */
        @Override
        public Scheduling scheduling() {
            Scheduling its = line.sample().scheduling();
            return !line.readings().isEmpty() && its != Scheduling.HOLDS ? Scheduling.BESIDE : its;
        }
    }

    /** Runs its body each time its condition becomes true, until the script ends. */
    record On(Token at, Late<Condition> condition, List<Statement> body) implements Statement {
        @Override
        public boolean isBlock() {
            return true;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.on(this);
        }
    }

    /** Makes a procedure known; does nothing else. */
    record ProcedureDefinition(Token at, Procedure procedure) implements Statement {
        @Override
        public boolean isBlock() {
            return true;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.procedure(this);
        }
    }

    /** Runs the body of a procedure with values for its arguments, one each. */
    record Call(Token at, Procedure procedure, List<Literal> given) implements Statement {
        @Override
        public boolean isBlock() {
            return true;
        }

        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.call(this);
        }
    }
}

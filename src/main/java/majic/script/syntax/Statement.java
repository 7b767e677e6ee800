package majic.script.syntax;

import java.util.List;
import java.util.OptionalInt;

/** One command, or a block of them. */
public sealed interface Statement {
    /** Where it begins. */
    Token at();

    <R> R accept(Visitor<R> visitor);

    /** One method for each kind of statement. */
    interface Visitor<R> {
        R repeat(Repeat repeat);

        R whileLoop(While loop);

        R choice(If choice);

        R forRobots(ForRobots command);

        R forSession(ForSession command);
    }

    /** Without times it is for ever. */
    record Repeat(Token at, OptionalInt times, List<Statement> body) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.repeat(this);
        }
    }

    record While(Token at, Condition condition, List<Statement> body) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.whileLoop(this);
        }
    }

    record If(Token at, Condition condition, List<Statement> body, List<Statement> otherwise) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.choice(this);
        }
    }

    record ForRobots(Token at, Robots robots, Command command) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.forRobots(this);
        }
    }

    record ForSession(Token at, SessionCommand command) implements Statement {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.forSession(this);
        }
    }
}

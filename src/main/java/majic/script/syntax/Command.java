package majic.script.syntax;

import java.util.List;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/** What a robot can be told. {@link Wording} puts it into the words that answers repeat. */
public sealed interface Command {
    /** Where the command's own word stands. */
    Token at();

    <R> R accept(Visitor<R> visitor);

    /** One method for each command. */
    interface Visitor<R> {
        R move(Move move);

        R turn(Turn turn);

        R drive(Drive drive);

        R stop(Stop stop);

        R get(Get get);

        R set(Set set);

        R log(Log log);

        R logOff(LogOff logOff);

        R act(Act act);

        R actOff(ActOff actOff);

        R await(Await await);

        R help(Help help);

        R own(Own own);
    }

    record Move(Token at, Literal distance, @Nullable Condition until) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.move(this);
        }
    }

    record Turn(Token at, Literal angle, @Nullable Condition until) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.turn(this);
        }
    }

    /** Seconds are missing where none were written. */
    record Drive(
            Token at,
            Literal speed,
            Literal rate,
            OptionalDouble seconds,
            @Nullable Condition until) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.drive(this);
        }
    }

    record Stop(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.stop(this);
        }
    }

    record Get(Token at, List<Token> parameters, boolean now) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.get(this);
        }
    }

    record Set(Token at, Token parameter, List<Literal> values) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.set(this);
        }
    }

    record Log(Token at, List<Token> parameters, Literal period) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.log(this);
        }
    }

    record LogOff(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.logOff(this);
        }
    }

    /** With the robots for its further roles, in their order. */
    record Act(Token at, Literal name, @Nullable Robots others) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.act(this);
        }
    }

    record ActOff(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.actOff(this);
        }
    }

    record Await(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.await(this);
        }
    }

    record Help(Token at, @Nullable Token parameter) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.help(this);
        }
    }

    /** A command that only some type of robot has. */
    record Own(Token at, List<Literal> arguments) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.own(this);
        }
    }
}

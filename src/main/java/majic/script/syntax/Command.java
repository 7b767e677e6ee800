package majic.script.syntax;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** A command for robots. */
public sealed interface Command extends Instruction {
    /** Where the command's own word stands. */
    Token at();

    <R> R accept(Visitor<R> visitor);

    /**
     * The words that answers repeat: without robots, MAJIC's own in lower case, names and numbers as they were written.
     */
    String text();

    /** The condition that ends a motion early; null for none. */
    default @Nullable Condition until() {
        return null;
    }

    @Override
    default Optional<String> refusalInAct() {
        return Optional.empty();
    }

    /** Further robots that it makes do something, as an act with several roles does; null for none. */
    default @Nullable Robots others() {
        return null;
    }

    /** The parameters that it reads or sets. */
    default List<Token> parameters() {
        return List.of();
    }

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

        R plot(Plot plot);

        R name(Name name);

        R place(Place place);

        R act(Act act);

        R actOff(ActOff actOff);

        R await(Await await);

        R help(Help help);

        R own(Own own);
    }

    /** Drives straight. */
    record Move(Token at, Literal distance, @Nullable Condition until) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.move(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public String text() {
            return "move " + distance.text() + untilText(until);
        }
    }

    /** Turns on the spot. */
    record Turn(Token at, Literal angle, @Nullable Condition until) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.turn(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public String text() {
            return "turn " + angle.text() + untilText(until);
        }
    }

    /** Drives a curve; seconds are missing where none were written. */
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

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public String text() {
            String speeds = "drive " + speed.text() + " " + rate.text();
            return seconds.isPresent()
                    ? speeds + " for " + inFull(seconds.getAsDouble()) + "s"
                    : speeds + untilText(until);
        }
    }

    /** Stops the robots. */
    record Stop(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.stop(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.STOP;
        }

        @Override
        public String text() {
            return "stop";
        }
    }

    /** Reads parameters; with {@code now} beside the queue. */
    record Get(Token at, List<Token> parameters, boolean now) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.get(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public String text() {
            return "get " + (now ? "now " : "") + names(parameters);
        }
    }

    /** Sets a parameter. */
    record Set(Token at, Token parameter, List<Literal> values) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.set(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return parameter.text().equalsIgnoreCase("maxMove")
                    ? List.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.CHANGES_LIMIT)
                    : List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public List<Token> parameters() {
            return List.of(parameter);
        }

        @Override
        public String text() {
            return "set " + parameter.text() + valueTexts(values);
        }
    }

    /** Shows parameters as curves. */
    record Plot(Token at, List<Token> parameters) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.plot(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public String text() {
            return "plot " + names(parameters);
        }
    }

    /** Logs parameters from now on, one reading each period. */
    record Log(Token at, List<Token> parameters, Literal period) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.log(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public String text() {
            return "log " + names(parameters) + " every " + period.text();
        }
    }

    /** Ends logging. */
    record LogOff(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.logOff(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public String text() {
            return "log off";
        }
    }

    /** Names a robot; {@code off} takes the name away, and without a word it is asked for. */
    record Name(Token at, @Nullable Token name) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.name(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.CHANGES_TEAM);
        }

        @Override
        public String text() {
            return name == null ? "name" : "name " + name.text();
        }
    }

    /** Puts a robot of the simulated lab down at a pose in the room's frame. */
    record Place(Token at, Literal x, Literal y, Literal heading) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.place(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public Optional<String> refusalInAct() {
            return SessionCommand.REFUSED_IN_ACT;
        }

        @Override
        public String text() {
            return "lab place " + pose();
        }

        /** The pose, as a line has it behind the robots. */
        public String pose() {
            return x.text() + " " + y.text() + " " + heading.text();
        }
    }

    /** A value given to a behaviour: {@code speed=200}. */
    record Argument(Token name, Literal value) {
        @Override
        public String toString() {
            return name.text() + "=" + value.text();
        }
    }

    /** Runs a behaviour, with values for its arguments and the robots for its further roles in their order. */
    record Act(
            Token at,
            Literal name,
            List<Argument> arguments,
            @Nullable Robots others) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.act(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.READS_FILES);
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.of("an act does not run others");
        }

        @Override
        public String text() {
            String given = arguments.stream().map(one -> " " + one).collect(Collectors.joining());
            return "act " + name.text() + given + (others == null ? "" : " with " + others.text());
        }
    }

    /** Ends the behaviour that a robot runs. */
    record ActOff(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.actOff(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE_IF_TYPED;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.of("an act does not run others");
        }

        @Override
        public String text() {
            return "act off";
        }
    }

    /** Waits until the robots have finished. */
    record Await(Token at) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.await(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public String text() {
            return "wait";
        }
    }

    /** Lists the commands and parameters of a robot, or describes one. */
    record Help(Token at, @Nullable Token parameter) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.help(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.of("an act needs none; leave the line out");
        }

        @Override
        public String text() {
            return parameter == null ? "help" : "help " + parameter.text();
        }
    }

    /** A command that only some type of robot has. */
    record Own(Token at, List<Literal> arguments) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.own(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS);
        }

        @Override
        public String text() {
            return at.text() + valueTexts(arguments);
        }
    }

    /** In full: a rounded time would drive further. */
    private static String inFull(double seconds) {
        return BigDecimal.valueOf(seconds).stripTrailingZeros().toPlainString();
    }

    private static String untilText(@Nullable Condition condition) {
        return condition == null ? "" : " until " + condition;
    }

    private static String names(List<Token> parameters) {
        return parameters.stream().map(Token::text).collect(Collectors.joining(","));
    }

    private static String valueTexts(List<Literal> values) {
        return values.stream().map(value -> " " + value.text()).collect(Collectors.joining());
    }
}

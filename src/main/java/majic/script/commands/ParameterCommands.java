package majic.script.commands;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Reading;
import majic.bot.Value;
import majic.log.Sampling;
import majic.script.run.Command;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** The commands for a robot's parameters, for their log, and those that only some types of robot have. */
public final class ParameterCommands {
    private ParameterCommands() {}

    /** Reads parameters; with {@code now} beside the queue. */
    record Get(Token at, List<Token> parameters, boolean now) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }

        @Override
        public String text() {
            return "get " + (now ? "now " : "") + words(parameters);
        }

        @Override
        public void check(Check check) {
            parameters.forEach(check::readable);
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            if (now) {
                execution.runNow(robots, this::command);
            } else {
                execution.readBeside(robots, this::command);
            }
        }

        private QueuedCommand command(Member member) {
            List<String> names = names(parameters, member.bot());
            return new QueuedCommand(text(), false, robot -> {
                Map<String, Reading> read = new LinkedHashMap<>();
                names.forEach(name -> read.put(name, robot.reading(name)));
                if (now) {
                    refuseOld(read);
                }
                return read.entrySet().stream()
                        .map(each -> each.getKey() + " = " + each.getValue())
                        .toList();
            });
        }

        /** An answer to {@code get now} consists of present values only. */
        private static void refuseOld(Map<String, Reading> read) {
            List<Reading> old = read.values().stream()
                    .filter(reading -> !reading.isCurrent())
                    .toList();
            if (old.isEmpty()) {
                return;
            }
            String reason = old.get(0).outdated();
            String last = read.entrySet().stream()
                    .filter(each ->
                            !each.getValue().isCurrent() && each.getValue().hasLast())
                    .map(each -> each.getKey() + " = " + each.getValue().last())
                    .collect(Collectors.joining(", "));
            throw new BotException(
                    last.isEmpty()
                            ? reason
                            : reason + "; at the last report, " + old.get(0).age() + " ago: " + last);
        }

        /** A typed reading was taken at once. */
        @Override
        public String replayText(Execution execution) {
            return new Get(at, parameters, now || execution.isTyped()).text();
        }
    }

    /** Sets a parameter. */
    record Set(Token at, Token parameter, List<Literal> literals) implements Command {
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
            return "set " + parameter.text() + valueTexts(literals);
        }

        @Override
        public void check(Check check) {
            if (!check.parameter(parameter).writable()) {
                throw new ScriptException(parameter, parameter.text() + ": can be read but not set");
            }
            Parameter known = check.parameter(parameter);
            List<Parameter> wanted = new ArrayList<>(known.extras());
            wanted.add(0, known);
            checkTimes(literals, index -> index < wanted.size() ? wanted.get(index) : null);
            literals.get(0).at().check(() -> check.bot().checkSet(parameter.text(), values(literals)));
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.submit(robots, this::command);
        }

        private QueuedCommand command(Member member) {
            String text = text();
            Parameter known = member.bot().parameter(parameter.text());
            return new QueuedCommand(text, known.moves(), robot -> {
                robot.set(known.name(), values(literals));
                return List.of(text + ": done");
            });
        }
    }

    /**
     * Logs parameters from now on, one reading each period. Moves nothing, so it does not wait for a motion if it is
     * typed.
     */
    record Log(Token at, List<Token> parameters, Literal period) implements Command {
        private static final double SHORTEST_PERIOD_S = 0.01;
        private static final double LONGEST_PERIOD_S = 86_400;

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public String text() {
            return "log " + words(parameters) + " every " + period.text();
        }

        /** A parameter is logged for the robots that have it; one that none of them has is a mistake. */
        @Override
        public void check(List<Check> robots) {
            for (Token name : parameters) {
                if (robots.stream().noneMatch(robot -> isReadable(name, robot.bot()))) {
                    robots.get(0).readable(name);
                }
            }
            if (period.number() < SHORTEST_PERIOD_S || period.number() > LONGEST_PERIOD_S) {
                throw new ScriptException(
                        period.at(), period.text() + ": the log takes from 10 ms to one day between readings");
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            Sampling sampling = execution.session().sampling();
            execution.readBeside(robots, member -> command(member, sampling));
        }

        private QueuedCommand command(Member member, Sampling sampling) {
            Map<Boolean, List<Token>> known =
                    parameters.stream().collect(Collectors.partitioningBy(name -> isReadable(name, member.bot())));
            List<String> names = names(known.get(true), member.bot());
            List<Token> missing = known.get(false);
            return new QueuedCommand(text(), false, robot -> {
                if (!names.isEmpty()) {
                    sampling.start(member, names, period.number());
                }
                return List.of(text() + ": " + outcome(names, missing));
            });
        }

        private static String outcome(List<String> logged, List<Token> missing) {
            if (missing.isEmpty()) {
                return "done";
            }
            String lacking = "it has no " + missing.stream().map(Token::text).collect(Collectors.joining(" and no "));
            return logged.isEmpty()
                    ? "nothing is logged, " + lacking
                    : "done; only " + String.join(", ", logged) + ", " + lacking;
        }

        private static boolean isReadable(Token name, MajicBot bot) {
            try {
                return bot.parameter(name.text()).readable();
            } catch (ParameterException e) {
                return false;
            }
        }
    }

    /** Ends logging. */
    record LogOff(Token at) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public String text() {
            return "log off";
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            Sampling sampling = execution.session().sampling();
            execution.readBeside(
                    robots,
                    member -> new QueuedCommand(text(), false, robot -> {
                        sampling.stop(member);
                        return List.of(text() + ": done");
                    }));
        }
    }

    /** Shows parameters as curves, in one plot for all robots of the command. */
    record Plot(Token at, List<Token> parameters) implements Command {
        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }

        @Override
        public String text() {
            return "plot " + words(parameters);
        }

        @Override
        public void check(Check check) {
            for (Token name : parameters) {
                check.readable(name);
                Parameter.Kind kind = check.bot().parameter(name.text()).kind();
                if (kind == Parameter.Kind.TEXT || kind == Parameter.Kind.CHOICE) {
                    throw new ScriptException(
                            name, name.text() + ": it is a word; only numbers and switches can be plotted");
                }
            }
        }

        /** Moves nothing, so it does not wait for a motion if it is typed. */
        @Override
        public void run(Execution execution, List<Member> robots) {
            int first = robots.get(0).number();
            execution.readBeside(
                    robots,
                    member -> new QueuedCommand(text(), false, robot -> {
                        if (member.number() == first) {
                            execution.session().plotting().show(robots, names(parameters, member.bot()));
                        }
                        return List.of(text() + ": done");
                    }));
        }
    }

    /** A command that only some type of robot has. */
    public record Own(Token at, List<Literal> arguments) implements Command {
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

        @Override
        public void check(Check check) {
            if (!Help.isCommand(at.text(), check.bot())) {
                throw new ScriptException(at, Help.noSuchCommand(at.text(), check.bot()));
            }
            described(check.bot()).ifPresent(command -> checkTimes(arguments, command::argument));
            Token place = arguments.isEmpty() ? at : arguments.get(0).at();
            place.check(() -> check.bot().checkRun(at.text(), values(arguments)));
        }

        private Optional<BotCommand> described(MajicBot bot) {
            return bot.commands().stream()
                    .filter(command -> command.name().equalsIgnoreCase(at.text()))
                    .findFirst();
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.submit(robots, this::command);
        }

        private QueuedCommand command(Member member) {
            boolean moves = described(member.bot()).filter(BotCommand::moves).isPresent();
            return new QueuedCommand(text(), moves, robot -> answers(robot.run(at.text(), values(arguments))));
        }

        private List<String> answers(String said) {
            return said.isBlank()
                    ? List.of(text() + ": done")
                    : Arrays.stream(said.strip().split("\\R"))
                            .map(line -> text() + ": " + line)
                            .toList();
        }
    }

    /** Whether a command begins or ends logging. */
    static boolean isLogging(QueuedCommand command) {
        return command.text().startsWith("log ");
    }

    /** Checks that every time has its unit where bare numbers would be milliseconds. */
    private static void checkTimes(List<Literal> literals, IntFunction<@Nullable Parameter> wanted) {
        for (int index = 0; index < literals.size(); index++) {
            Parameter parameter = wanted.apply(index);
            if (parameter != null) {
                literals.get(index).valueFor(parameter);
            }
        }
    }

    private static List<Value> values(List<Literal> literals) {
        return literals.stream().map(Literal::value).toList();
    }

    private static String words(List<Token> parameters) {
        return parameters.stream().map(Token::text).collect(Collectors.joining(","));
    }

    private static String valueTexts(List<Literal> values) {
        return values.stream().map(value -> " " + value.text()).collect(Collectors.joining());
    }

    private static List<String> names(List<Token> parameters, MajicBot bot) {
        return parameters.stream()
                .map(name -> name.resolve(() -> bot.parameter(name.text()).name()))
                .toList();
    }
}

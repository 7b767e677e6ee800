package majic.script.actions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
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
import majic.script.help.Help;
import majic.script.run.Execution;
import majic.script.run.RobotAction;
import majic.script.syntax.Command;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.Member;
import majic.team.QueuedCommand;
import org.jspecify.annotations.Nullable;

/** The commands for a robot's parameters, for their log, and those that only some types of robot have. */
final class ParameterActions {
    private ParameterActions() {}

    static final class GetAction extends RobotAction {
        private final Command.Get get;

        GetAction(Command.Get get) {
            super(get);
            this.get = get;
        }

        @Override
        public void check(Check check) {
            get.parameters().forEach(check::readable);
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            if (get.now()) {
                execution.runNow(robots, this::command);
            } else {
                execution.readBeside(robots, this::command);
            }
        }

        private QueuedCommand command(Member member) {
            List<String> names = names(get.parameters(), member.bot());
            return new QueuedCommand(text(), false, robot -> {
                Map<String, Reading> read = new LinkedHashMap<>();
                names.forEach(name -> read.put(name, robot.reading(name)));
                if (get.now()) {
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
        public String replayText(boolean typed) {
            return new Command.Get(get.at(), get.parameters(), typed || get.now()).text();
        }
    }

    static final class SetAction extends RobotAction {
        private final Token parameter;
        private final List<Literal> literals;

        SetAction(Command.Set set) {
            super(set);
            this.parameter = set.parameter();
            this.literals = set.values();
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
            Parameter known = member.bot().parameter(parameter.text());
            return new QueuedCommand(text(), known.moves(), robot -> {
                robot.set(known.name(), values(literals));
                return List.of(text() + ": done");
            });
        }
    }

    /** Moves nothing, so it does not wait for a motion if it is typed. */
    static final class LogAction extends RobotAction {
        private static final double SHORTEST_PERIOD_S = 0.01;
        private static final double LONGEST_PERIOD_S = 86_400;

        private final Command.Log log;
        private final Sampling sampling;

        LogAction(Command.Log log, Sampling sampling) {
            super(log);
            this.log = log;
            this.sampling = sampling;
        }

        /** A parameter is logged for the robots that have it; one that none of them has is a mistake. */
        @Override
        public void check(List<Check> robots) {
            for (Token name : log.parameters()) {
                if (robots.stream().noneMatch(robot -> isReadable(name, robot.bot()))) {
                    robots.get(0).readable(name);
                }
            }
            check(robots.get(0));
        }

        @Override
        public void check(Check check) {
            double seconds = log.period().value().number();
            if (seconds < SHORTEST_PERIOD_S || seconds > LONGEST_PERIOD_S) {
                throw new ScriptException(
                        log.period().at(),
                        log.period().text() + ": the log takes from 10 ms to one day between readings");
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.readBeside(robots, this::command);
        }

        private QueuedCommand command(Member member) {
            Map<Boolean, List<Token>> parameters = log.parameters().stream()
                    .collect(Collectors.partitioningBy(name -> isReadable(name, member.bot())));
            List<String> names = names(parameters.get(true), member.bot());
            List<Token> missing = parameters.get(false);
            double seconds = log.period().value().number();
            return new QueuedCommand(text(), false, robot -> {
                if (!names.isEmpty()) {
                    sampling.start(member, names, seconds);
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

        /** Whether a command begins or ends logging. */
        static boolean isLogging(QueuedCommand command) {
            return command.text().startsWith("log ");
        }
    }

    static final class LogOffAction extends RobotAction {
        private final Sampling sampling;

        LogOffAction(Command.LogOff logOff, Sampling sampling) {
            super(logOff);
            this.sampling = sampling;
        }

        @Override
        public void check(Check check) {}

        @Override
        public void run(Execution execution, List<Member> robots) {
            Function<Member, QueuedCommand> command = member -> new QueuedCommand(text(), false, robot -> {
                sampling.stop(member);
                return List.of(text() + ": done");
            });
            execution.readBeside(robots, command);
        }
    }

    /** Opens one plot for all robots of the command. Moves nothing, so it does not wait for a motion if it is typed. */
    static final class PlotAction extends RobotAction {
        private final Command.Plot plot;
        private final Plotting plotting;

        PlotAction(Command.Plot plot, Plotting plotting) {
            super(plot);
            this.plot = plot;
            this.plotting = plotting;
        }

        @Override
        public void check(Check check) {
            for (Token name : plot.parameters()) {
                check.readable(name);
                Parameter.Kind kind = check.bot().parameter(name.text()).kind();
                if (kind == Parameter.Kind.TEXT || kind == Parameter.Kind.CHOICE) {
                    throw new ScriptException(
                            name, name.text() + ": it is a word; only numbers and switches can be plotted");
                }
            }
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            int first = robots.get(0).number();
            execution.readBeside(
                    robots,
                    member -> new QueuedCommand(text(), false, robot -> {
                        if (member.number() == first) {
                            plotting.show(robots, names(plot.parameters(), member.bot()));
                        }
                        return List.of(text() + ": done");
                    }));
        }
    }

    /** A command that only some type of robot has. */
    static final class OwnAction extends RobotAction {
        private final Token word;
        private final List<Literal> arguments;

        OwnAction(Command.Own own) {
            super(own);
            this.word = own.at();
            this.arguments = own.arguments();
        }

        @Override
        public void check(Check check) {
            if (!check.isCommand(word.text())) {
                throw new ScriptException(word, Help.noSuchCommand(word.text(), check.bot()));
            }
            described(check.bot()).ifPresent(command -> checkTimes(arguments, command::argument));
            Token place = arguments.isEmpty() ? word : arguments.get(0).at();
            place.check(() -> check.bot().checkRun(word.text(), values(arguments)));
        }

        private Optional<BotCommand> described(MajicBot bot) {
            return bot.commands().stream()
                    .filter(command -> command.name().equalsIgnoreCase(word.text()))
                    .findFirst();
        }

        @Override
        public void run(Execution execution, List<Member> robots) {
            execution.submit(robots, this::command);
        }

        private QueuedCommand command(Member member) {
            boolean moves = described(member.bot()).filter(BotCommand::moves).isPresent();
            return new QueuedCommand(text(), moves, robot -> answers(robot.run(word.text(), values(arguments))));
        }

        private List<String> answers(String said) {
            return said.isBlank()
                    ? List.of(text() + ": done")
                    : Arrays.stream(said.strip().split("\\R"))
                            .map(line -> text() + ": " + line)
                            .toList();
        }
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

    private static List<String> names(List<Token> parameters, MajicBot bot) {
        return parameters.stream()
                .map(name -> name.resolve(() -> bot.parameter(name.text()).name()))
                .toList();
    }
}

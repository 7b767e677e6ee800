package majic.script.commands;

import static java.util.Map.entry;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.BotCommand;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/** The words of the language, and the answers to {@code help} about them and about robots. */
public final class Help {
    private static final String ROBOT_1 = "1 ";

    private static final Map<String, String> ROBOT_COMMANDS = new TreeMap<>(Map.ofEntries(
            entry("move", "1 move DISTANCE [until CONDITION]: straight ahead; negative is backward"),
            entry("turn", "1 turn ANGLE [until CONDITION]: on the spot, left positive"),
            entry(
                    "drive",
                    "1 drive SPEED TURNRATE [for TIME | until CONDITION]: a curve, one second unless a time is given"),
            entry(
                    "goto",
                    "1 goto X Y [HEADING] [until CONDITION], 1 goto PLACE: drives to a place, around what is in the way"),
            entry(
                    "explore",
                    "1 explore [until CONDITION]: drives where the map that it builds is unknown, until nothing is left that it can reach"),
            entry(
                    "stop",
                    "1 stop: ends the motion, empties the queue, ends act and script; \"stop\" alone is STOP for all"),
            entry("get", "1 get P[,P...]: reads parameters; \"get now P\" does not wait for its turn"),
            entry("set", "1 set P VALUE...: sets a parameter"),
            entry("log", "1 log P[,P...] every TIME: to the parameter log; \"1 log off\" ends it"),
            entry("plot", "1 plot P[,P...]: shows readings as curves in a window"),
            entry(
                    "name",
                    "1 name NAME: NAME may be used for 1 from then on; \"1 name\" shows it, \"1 name off\" removes it"),
            entry(
                    "act",
                    "1 act NAME [ARGUMENT=VALUE...] [with ROBOTS]: runs an act, a script or an .act file; \"1 act off\" ends it"),
            entry(
                    "wait",
                    "1 wait: holds what follows until robot 1 has finished; \"wait\" for all, \"wait 2s\" for a time"),
            entry("localize", "1 localize: looks for the robot everywhere on the map, while it drives"),
            entry("help", "1 help [P]: commands and parameters of robot 1; \"help\" alone: the language")));

    private static final Map<String, String> SESSION_COMMANDS = new TreeMap<>(Map.ofEntries(
            entry("acts", "acts [NAME]: lists the acts, or describes one and its arguments"),
            entry("add", "add URI [as N]: add aibo://192.168.1.20, add pioneer://10.0.0.5:8101, add sim:pioneer"),
            entry("remove", "remove ROBOTS: stops and closes them"),
            entry("bots", "bots: lists the robots and their states"),
            entry("probe", "probe URI: shows what answers there, and what to try if nothing does"),
            entry("release", "release: allows motion again after STOP"),
            entry("run", "run FILE: runs a script"),
            entry(
                    "save",
                    "save session FILE, save log FILE, save team FILE: the session as a script, the parameter log as CSV, the robots as a script"),
            entry(
                    "lab",
                    "lab: shows the true poses in the simulated lab, and how often each robot ran into something; lab place 2 X Y HEADING puts robot 2 there, lab carry does so without telling it"),
            entry(
                    "trust",
                    "trust [FILE [HASH]]: shows the code in an act; with its hash it gives consent to run it; trust off FILE takes that back; trust alone lists the consents"),
            entry(
                    "map",
                    "map start ROBOT, map stop: a robot builds the map while it drives; map save FILE, map open FILE, map close; map rows lists its cells; map place NAME X Y [HEADING], map place NAME as OTHER, map place NAME off; map alone describes it"),
            entry(
                    "let",
                    "let NAME = VALUE: gives a value a name, as in let n = $n + 1; in a line $NAME or an expression in brackets stands for a value: 1 move ($n * 100)"),
            entry("print", "print TEXT and values: shows them, as in print \"left\" $left (1 distanceFront / 2)"),
            entry(
                    "ask",
                    "ask NAME = DEFAULT [from MIN to MAX] [\"QUESTION\"] [for TIME]: asks a person for a value; without an answer in time it is the default"),
            entry("answer", "answer VALUE: answers the question of a script"),
            entry("quit", "quit: stops and closes all robots and ends MAJIC")));

    /** The words of the commands that every robot has. */
    static final List<String> ROBOT_WORDS = List.copyOf(ROBOT_COMMANDS.keySet());

    /** The words that a command for the session begins with; of some there is a command for robots as well. */
    static final List<String> SESSION_WORDS = Stream.concat(
                    SESSION_COMMANDS.keySet().stream(), Stream.of("help", "stop", "wait"))
            .sorted()
            .toList();

    private static final Map<String, String> BLOCKS = new TreeMap<>(Map.of(
            "repeat", "repeat [N] ... end: N times, or for ever",
            "while", "while CONDITION ... end: as long as it holds, as in while 1 distanceFront > 300",
            "on", "on CONDITION ... end: each time it becomes true, while the script runs",
            "to", "to NAME [ARGUMENT...] ... end: a procedure; NAME and a value for each argument runs it",
            "if", "if CONDITION ... [else ...] end: conditions take and, or, not and brackets"));

    /** Each word of the language with its line, in the order in which {@code help} shows them. */
    private static final Map<String, String> LINES = lines();

    private Help() {}

    private static Map<String, String> lines() {
        Map<String, String> lines = new LinkedHashMap<>(ROBOT_COMMANDS);
        lines.putAll(BLOCKS);
        lines.putAll(SESSION_COMMANDS);
        return lines;
    }

    /** The topics of {@code help}. */
    public static TreeSet<String> topics() {
        TreeSet<String> topics = new TreeSet<>(List.of("commands", "robots"));
        topics.addAll(LINES.keySet());
        return topics;
    }

    /** For the language, or one word of it. */
    public static List<String> of(BotFactory factory, Team team, @Nullable Token topic) {
        String word = topic == null ? "" : topic.text().toLowerCase(Locale.ROOT);
        return switch (word) {
            case "" -> all();
            case "commands" -> List.copyOf(LINES.values());
            case "robots" -> robots(factory, team);
            default ->
                Optional.ofNullable(LINES.get(word)).map(line -> "help: " + line).stream()
                        .toList();
        };
    }

    private static List<String> all() {
        List<String> lines = new ArrayList<>();
        lines.add("robots are named by a number, a name, a list 1,3, a range 1-4, a type, or all");
        lines.addAll(LINES.values());
        return lines;
    }

    /**
     * A word of the language or a topic of {@code help}, with what it takes and what it does: {@code stop: ends it}.
     *
     * @return the words behind it, a colon and the explanation; without a colon if there is no explanation
     */
    public static String explained(String word) {
        String line = switch (word) {
            case "commands" -> "commands: all commands";
            case "robots" -> "robots: the types of robots, and the robots of the team";
            case "else" -> "else: what is done if the condition does not hold";
            case "end" -> "end: the end of the block";
            default -> LINES.getOrDefault(word, word);
        };
        return line.substring(word.length() + (line.startsWith(ROBOT_1) ? ROBOT_1.length() : 0));
    }

    private static List<String> robots(BotFactory factory, Team team) {
        List<String> lines = new ArrayList<>();
        factory.types()
                .forEach(type ->
                        lines.add(type.name() + ": " + type.make() + ", added with \"add " + addresses(type) + "\""));
        lines.add(team.listing());
        return lines;
    }

    private static String addresses(BotType type) {
        int port = type.defaultPort(type.name());
        String rest = port > 0 ? "://HOST:" + port : ":PORT";
        return type.name()
                + rest
                + type.libraries().stream()
                        .map(library ->
                                "\" or, by the library " + library + ", \"add " + type.name() + "+" + library + rest)
                        .collect(Collectors.joining());
    }

    /** For one robot, or one parameter or command of it. */
    public static List<String> of(Member member, @Nullable Token topic) {
        MajicBot bot = member.bot();
        List<String> lines = new ArrayList<>();
        if (topic == null) {
            lines.add(String.join(", ", ROBOT_COMMANDS.keySet()));
        }
        bot.commands().stream().filter(own -> isAsked(own.name(), topic)).forEach(own -> lines.add(describe(own)));
        List<Parameter> asked = bot.parameters().stream()
                .filter(own -> isAsked(own.name(), topic))
                .toList();
        ParameterGroup.of(asked).forEach(group -> lines.add(describe(group)));
        if (lines.isEmpty() && topic != null) {
            lines.add(ROBOT_COMMANDS
                    .getOrDefault(topic.text().toLowerCase(Locale.ROOT), "nothing known")
                    .substring(2));
        }
        return lines.stream().map(line -> member.number() + " " + line).toList();
    }

    private static boolean isAsked(String name, @Nullable Token topic) {
        return topic == null || topic.is(name);
    }

    private static String describe(BotCommand command) {
        return command.usage() + ": " + command.help() + (command.moves() ? " (may move the robot)" : "");
    }

    private static String describe(ParameterGroup group) {
        Parameter parameter = group.first();
        List<String> facts = new ArrayList<>();
        facts.add(values(parameter));
        facts.add((parameter.readable() ? "get" : "") + (parameter.writable() ? " set" : ""));
        facts.add(parameter.moves() ? "moves the robot" : "");
        parameter.extras().forEach(extra -> facts.add("then " + extra.name() + " " + values(extra)));
        String known = facts.stream()
                .map(String::strip)
                .filter(fact -> !fact.isEmpty())
                .collect(Collectors.joining("; "));
        return group.name() + " (" + known + "): " + parameter.help();
    }

    /** The values that a parameter takes, in a few words: a range with its unit, or the words to choose from. */
    public static String values(Parameter parameter) {
        return switch (parameter.kind()) {
            case NUMBER, LIST -> {
                boolean bounded = !parameter.range().equals(Range.ANY);
                String unit = parameter.unit() == Unit.NONE
                        ? parameter.whole() ? "whole number" : "number"
                        : parameter.unit().symbol();
                yield bounded ? parameter.range() + " " + unit : unit;
            }
            case YES_NO -> "yes/no";
            case ON_OFF -> "on/off";
            case CHOICE -> String.join("/", parameter.choices());
            case TEXT -> "text";
        };
    }

    /** Whether a robot has a command of that name. */
    static boolean isCommand(String word, MajicBot bot) {
        return ROBOT_WORDS.contains(word.toLowerCase(Locale.ROOT))
                || bot.commands().stream().anyMatch(own -> own.name().equalsIgnoreCase(word));
    }

    static String noSuchCommand(String word, MajicBot bot) {
        if (bot.parameters().stream().anyMatch(parameter -> parameter.name().equalsIgnoreCase(word))) {
            return word + ": a parameter; read it with get, or change it with set";
        }
        List<String> words = new ArrayList<>(ROBOT_WORDS);
        words.addAll(bot.commands().stream().map(BotCommand::name).toList());
        return word + ": " + bot.name() + " has no such command" + Suggestion.didYouMean(word, words);
    }
}

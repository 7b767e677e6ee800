package majic.script.help;

import java.util.ArrayList;
import java.util.List;
import majic.act.ActArgument;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.BotType;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.lab.LabAccess;
import majic.script.commands.Help;
import majic.script.commands.LineParser;
import majic.script.commands.ScriptParser;
import majic.script.commands.SessionParser;
import majic.script.run.Procedure;
import majic.script.syntax.Operand;
import majic.team.Member;

/** Words of the language and names of robots, parameters and addresses, each with its explanation. */
final class Explained {
    private Explained() {}

    private static final String SEPARATOR = ": ";

    /** The words that begin a command for the session or a block. */
    static List<Completion> sessionWords() {
        List<Completion> words = new ArrayList<>();
        SessionParser.WORDS.forEach(word -> words.add(word(word)));
        ScriptParser.BLOCK_WORDS.forEach(word -> words.add(word(word)));
        return words;
    }

    /** A word of the language or a topic of {@code help}, with what it takes and what it does. */
    static Completion word(String word) {
        String behind = Help.explained(word);
        int colon = behind.indexOf(SEPARATOR);
        return colon < 0
                ? new Completion(word, behind.strip(), "")
                : new Completion(
                        word, behind.substring(0, colon).strip(), behind.substring(colon + SEPARATOR.length()));
    }

    /** The commands that every robot has, and those that some of the given robots have. */
    static List<Completion> commands(List<Member> members) {
        List<Completion> words = new ArrayList<>();
        LineParser.COMMAND_WORDS.forEach(word -> words.add(word(word)));
        members.forEach(member ->
                member.bot().commands().stream().map(Explained::command).forEach(words::add));
        return words;
    }

    private static Completion command(BotCommand command) {
        return new Completion(
                command.name(),
                command.usage().substring(command.name().length()).strip(),
                command.help());
    }

    /** The numbers, names and types of robots, and {@code all}. */
    static List<Completion> robots(List<Member> members) {
        List<Completion> words = new ArrayList<>();
        words.add(Completion.word("all", "every robot"));
        for (Member member : members) {
            BotType type = member.bot().type();
            words.add(Completion.word(String.valueOf(member.number()), member.label()));
            if (!member.name().isEmpty()) {
                words.add(Completion.word(member.name(), "robot " + member.number() + ", " + type.label()));
            }
            words.add(Completion.word(type.name(), "every " + type.label()));
        }
        return words;
    }

    /** The beginnings of the addresses of a type, and those at serial ports. */
    static List<Completion> addresses(BotType type, List<String> serialPorts) {
        List<Completion> words = new ArrayList<>();
        String place = type.canListRobots() ? "/SITE/DESK/NUMBER" : "";
        int port = type.defaultPort(type.name());
        String rest = port > 0 ? "//HOST:" + port + place : "PORT";
        words.add(new Completion(type.name() + ":", rest, type.make()));
        for (String library : type.libraries()) {
            words.add(new Completion(type.name() + "+" + library + ":", rest, type.make() + ", by " + library));
        }
        if (type.reaches().contains(BotType.Reach.SERIAL)) {
            serialPorts.forEach(name -> words.add(Completion.word(type.name() + ":" + name, "a serial port")));
        }
        return words;
    }

    static List<Completion> addresses(LabAccess lab) {
        return lab.robots().stream()
                .map(robot -> Completion.word(BotAddress.SIMULATED + ":" + robot, "in the simulated lab"))
                .toList();
    }

    static Completion parameter(Parameter parameter) {
        return new Completion(parameter.name(), Help.values(parameter), parameter.help());
    }

    /** The words that a value may be; a hint if there are none. */
    static List<Completion> values(Parameter parameter) {
        List<String> words = switch (parameter.kind()) {
            case ON_OFF -> List.of("on", "off");
            case YES_NO -> List.of("yes", "no");
            case CHOICE -> parameter.choices();
            case NUMBER, TEXT, LIST -> List.of();
        };
        String explanation = parameter.name() + ": " + parameter.help();
        return words.isEmpty()
                ? List.of(new Completion("", Help.values(parameter), explanation))
                : words.stream().map(word -> Completion.word(word, explanation)).toList();
    }

    /** The name of an act's argument, ready for a value. */
    static Completion argument(ActArgument argument) {
        Parameter parameter = argument.parameter();
        return new Completion(parameter.name() + "=", withDefault(parameter, argument.initial()), parameter.help());
    }

    /** The name that stands for the value of a script's argument. */
    static Completion variable(Parameter parameter, Value initial) {
        return new Completion("$" + parameter.name(), withDefault(parameter, initial), parameter.help());
    }

    /** A name that stands for a value of which only the kind is known. */
    static Completion variable(String name, Operand kind) {
        return new Completion("$" + name, kind.any() ? "" : kind.kind(), kind.any() ? "a value" : "");
    }

    /** A procedure with the names of its arguments. */
    static Completion procedure(Procedure procedure) {
        String name = procedure.name().text();
        return new Completion(
                name, procedure.toString().substring(name.length()).strip(), "a procedure");
    }

    private static String withDefault(Parameter parameter, Value initial) {
        boolean text = parameter.kind() == Parameter.Kind.TEXT;
        return Help.values(parameter) + ", default " + (text ? ActArgument.typed(initial) : initial);
    }

    /** The words that the value of an act's argument may be, the default among them; and what it is for. */
    static List<Completion> values(ActArgument argument) {
        Parameter parameter = argument.parameter();
        List<Completion> values = new ArrayList<>(values(parameter));
        if (values.get(0).isHint()) {
            values.add(Completion.word(argument.typed(), "the default"));
        }
        return values;
    }

    /** What the parser expects, as in "a distance (mm, cm, m)". */
    static Completion expected(String what) {
        int units = what.endsWith(")") ? what.lastIndexOf(" (") : -1;
        return units < 0
                ? new Completion("", "", what)
                : new Completion("", what.substring(units + 2, what.length() - 1), what.substring(0, units));
    }
}

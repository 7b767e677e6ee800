package majic.script.help;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import majic.bot.BotAddress;
import majic.bot.BotCommand;
import majic.bot.BotType;
import majic.bot.Parameter;
import majic.script.syntax.Cursor;
import majic.script.syntax.LineParser;
import majic.script.syntax.Robots;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.ScriptParser;
import majic.script.syntax.SessionParser;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;

/** Finds what could stand at the end of a line that is being typed. */
public final class Completion {
    private static final List<String> CONDITION_WORDS = List.of("until", "while", "if", "and", "or", "not", "any");

    private final Team team;
    private final BotFactory factory;
    private final Function<Robots, List<Member>> selection;
    private final ActNames acts;

    /** The behaviours that could be named on a line. Both read files. */
    public interface ActNames {
        List<String> names();

        /** Those that can be loaded onto each of some robots, as a line would name them. */
        List<String> namesFor(List<Member> robots);
    }

    public Completion(Team team, BotFactory factory, Function<Robots, List<Member>> selection, ActNames acts) {
        this.team = team;
        this.factory = factory;
        this.selection = selection;
        this.acts = acts;
    }

    /** Whole words that begin like the last one of the text, sorted. */
    public List<String> complete(String text) {
        int start = text.length();
        while (start > 0 && isPartOfWord(text.charAt(start - 1))) {
            start--;
        }
        String begun = text.substring(start).toLowerCase(Locale.ROOT);
        TreeSet<String> found = new TreeSet<>(String.CASE_INSENSITIVE_ORDER);
        found.addAll(candidates(Scanner.scan(text.substring(0, start))));
        return found.stream()
                .filter(word -> word.toLowerCase(Locale.ROOT).startsWith(begun))
                .toList();
    }

    private static boolean isPartOfWord(char sign) {
        return Character.isLetterOrDigit(sign) || sign == '_' || sign == ':' || sign == '/';
    }

    private Collection<String> candidates(List<Token> before) {
        List<Token> tokens = before.stream().filter(token -> !token.isEnd()).toList();
        if (tokens.isEmpty()) {
            return firstWords();
        }
        Token first = tokens.get(0);
        if (isSession(first)) {
            return afterSession(tokens);
        }
        int command = commandAt(tokens);
        List<Member> members = members(tokens.subList(0, command));
        return command == tokens.size() ? commandWords(members) : afterCommand(tokens, command, members);
    }

    private static boolean isSession(Token first) {
        String word = first.text().toLowerCase(Locale.ROOT);
        return SessionParser.WORDS.contains(word) || ScriptParser.BLOCK_WORDS.contains(word);
    }

    private Collection<String> firstWords() {
        List<String> words = new ArrayList<>(SessionParser.WORDS);
        words.addAll(ScriptParser.BLOCK_WORDS);
        words.addAll(robotWords());
        return words;
    }

    private Collection<String> robotWords() {
        List<String> words = new ArrayList<>(List.of("all"));
        for (Member member : team.members()) {
            words.add(String.valueOf(member.number()));
            words.add(member.bot().type().name());
        }
        return words;
    }

    private Collection<String> afterSession(List<Token> tokens) {
        Token last = tokens.get(tokens.size() - 1);
        return switch (tokens.get(0).text().toLowerCase(Locale.ROOT)) {
            case "add", "probe" -> tokens.size() == 1 ? addresses() : List.of("as");
            case "save" -> tokens.size() == 1 ? List.of("log", "session", "team") : List.of();
            case "remove" -> robotWords();
            case "trust" -> tokens.size() == 1 ? acts.names() : List.of();
            case "help" -> tokens.size() == 1 ? Help.topics() : List.of();
            case "while", "if" -> afterCondition(last, team.members());
            default -> List.of();
        };
    }

    private Collection<String> addresses() {
        List<String> words = new ArrayList<>();
        for (BotType type : factory.types()) {
            words.add(type.name() + ":");
            type.libraries().forEach(library -> words.add(type.name() + "+" + library + ":"));
        }
        factory.lab().ifPresent(lab -> lab.robots().forEach(robot -> words.add(BotAddress.SIMULATED + ":" + robot)));
        return words;
    }

    /** Where the robots of a line end: behind the last comma there is one more. */
    private static int commandAt(List<Token> tokens) {
        int index = 1;
        while (index + 1 < tokens.size() && tokens.get(index).kind() == Token.Kind.COMMA) {
            index += 2;
        }
        boolean call = index < tokens.size() && tokens.get(index).kind() == Token.Kind.DOT;
        return call ? index + 1 : index;
    }

    private List<Member> members(List<Token> names) {
        List<Token> tokens = new ArrayList<>(names);
        Token last = tokens.get(tokens.size() - 1);
        tokens.add(new Token(Token.Kind.END, "", last.line(), last.end(), last.end()));
        try {
            return selection.apply(Robots.parse(new Cursor(tokens)));
        } catch (ScriptException e) {
            return List.of();
        }
    }

    private static Collection<String> commandWords(List<Member> members) {
        List<String> words = new ArrayList<>(LineParser.COMMAND_WORDS);
        members.forEach(member -> words.addAll(
                member.bot().commands().stream().map(BotCommand::name).toList()));
        return words;
    }

    private Collection<String> afterCommand(List<Token> tokens, int command, List<Member> members) {
        Token last = tokens.get(tokens.size() - 1);
        boolean named = tokens.size() == command + 1 || last.kind() == Token.Kind.COMMA || last.is("now");
        return switch (tokens.get(command).text().toLowerCase(Locale.ROOT)) {
            case "get", "help" -> named ? parameters(members, false) : List.of();
            case "log" -> named ? with(parameters(members, false), "off") : List.of("every");
            case "set" ->
                tokens.size() == command + 1 ? parameters(members, true) : words(tokens.get(command + 1), members);
            case "act" ->
                tokens.size() == command + 1 ? with(acts.namesFor(members), "off") : with(robotWords(), "with");
            case "move", "turn" ->
                tokens.size() > command + 1 ? with(afterCondition(last, members), "until") : List.of();
            case "drive" -> with(with(afterCondition(last, members), "until"), "for");
            default -> arguments(tokens.get(command), tokens.size() - command - 1, members);
        };
    }

    private static Collection<String> arguments(Token name, int index, List<Member> members) {
        return members.stream()
                .flatMap(member -> member.bot().commands().stream())
                .filter(command -> name.is(command.name()))
                .map(command -> command.argument(index))
                .flatMap(argument -> argument == null ? Stream.empty() : words(argument).stream())
                .toList();
    }

    private Collection<String> afterCondition(Token last, List<Member> members) {
        boolean begins = CONDITION_WORDS.stream().anyMatch(last::is) || last.kind() == Token.Kind.LEFT;
        if (begins) {
            return with(with(parameters(members, false), "any"), "not");
        }
        return last.kind() == Token.Kind.OPERATOR
                ? with(with(with(parameters(members, false), "clear"), "yes"), "no")
                : List.of("and", "or");
    }

    private static Collection<String> parameters(List<Member> members, boolean writable) {
        return members.stream()
                .flatMap(member -> member.bot().parameters().stream())
                .filter(parameter -> writable ? parameter.writable() : parameter.readable())
                .map(Parameter::name)
                .toList();
    }

    private static Collection<String> words(Token name, List<Member> members) {
        List<String> words = new ArrayList<>();
        members.stream()
                .flatMap(member -> member.bot().parameters().stream())
                .filter(parameter -> name.is(parameter.name()))
                .forEach(parameter -> words.addAll(words(parameter)));
        return words;
    }

    private static List<String> words(Parameter parameter) {
        return switch (parameter.kind()) {
            case ON_OFF -> List.of("on", "off");
            case YES_NO -> List.of("yes", "no");
            case CHOICE -> parameter.choices();
            case NUMBER, TEXT, LIST -> List.of();
        };
    }

    private static Collection<String> with(Collection<String> words, String further) {
        List<String> all = new ArrayList<>(words);
        all.add(further);
        return all;
    }
}

package majic.script.help;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.act.ActArgument;
import majic.bot.BotType;
import majic.script.commands.Help;
import majic.script.commands.LineParser;
import majic.script.commands.ScriptParser;
import majic.script.commands.SessionParser;
import majic.script.run.Scope;
import majic.script.run.Types;
import majic.script.syntax.Cursor;
import majic.script.syntax.Operand;
import majic.script.syntax.Robots;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;

/**
 * Finds what could stand at a place of a line that is being typed: words of the language, robots, their commands and
 * parameters, the words that a value may be, acts that fit the robots. Where anything may be typed, it states what is
 * expected.
 */
public final class Completer {
    private static final List<String> CONDITIONAL = List.of("if", "on", "while");
    private static final Completion OFF = Completion.word("off", "ends it");
    private static final Completion NAME = new Completion("", "NAME", "one word of letters, digits and _");
    private static final Completion UNTIL =
            new Completion("until", "CONDITION", "ends the motion as soon as the condition holds");

    private static final Completion LONGEST = new Completion("for", "TIME", "how long the question waits");

    private static final List<Completion> MAP = List.of(
            new Completion("start", "ROBOT", "the robot builds a map while it drives"),
            Completion.word("stop", "ends that"),
            new Completion("save", "FILE", "writes the map"),
            new Completion("open", "FILE", "opens a map"),
            Completion.word("close", "removes the map"),
            Completion.word("rows", "lists its cells"),
            new Completion("place", "NAME X Y [HEADING]", "gives a place a name"));

    private final Team team;
    private final BotFactory factory;
    private final Function<Robots, List<Member>> selection;
    private final Supplier<List<String>> places;
    private final Acts acts;

    /** The behaviours that could be named on a line. All methods but the last read files. */
    public interface Acts {
        /** Returns all of them, as a line would name them. */
        List<Completion> completions();

        /** Returns those that can be loaded onto each of some robots. */
        List<Completion> completionsFor(List<Member> robots);

        /** Returns the arguments that one takes; none if it cannot be read. */
        List<ActArgument> argumentsOf(String act);

        /** Returns whether a file with this name may be one of them. */
        boolean isFile(String name);
    }

    /**
     * Completes lines for a team.
     *
     * @param places the names of the places of the map
     */
    public Completer(
            Team team,
            BotFactory factory,
            Function<Robots, List<Member>> selection,
            Supplier<List<String>> places,
            Acts acts) {
        this.team = team;
        this.factory = factory;
        this.selection = selection;
        this.places = places;
        this.acts = acts;
    }

    /**
     * Completes the word before the caret.
     *
     * @param line one line
     * @param caret 0 to the length of the line
     * @param unnamed the robots that a line without robots is for; empty for none
     * @param names those that the line may use
     */
    public Completions complete(String line, int caret, List<Member> unnamed, VisibleNames names) {
        String typed = line.substring(0, caret);
        List<Token> tokens = new ArrayList<>(Scanner.scan(typed));
        int commentFrom = tokens.get(tokens.size() - 2).column() - 1;
        tokens.removeIf(Token::isEnd);
        if (commentFrom < typed.length()) {
            return new Completions(caret, List.of());
        }
        return files(typed, tokens).orElseGet(() -> words(typed, tokens, unnamed, names));
    }

    /** Completes the name of a file; empty if no file is named at the end of a text. */
    private Optional<Completions> files(String typed, List<Token> tokens) {
        String first = tokens.isEmpty() ? "" : tokens.get(0).text().toLowerCase(Locale.ROOT);
        return switch (first) {
            case "run" -> BegunFile.of(typed, tokens, 1).map(BegunFile::completions);
            case "save" -> BegunFile.of(typed, tokens, 2).map(BegunFile::completions);
            case "acts", "trust" -> actFiles(typed, tokens, 1);
            default -> {
                int command = commandAt(tokens);
                boolean act = command < tokens.size() && tokens.get(command).is("act");
                yield act ? actFiles(typed, tokens, command + 1) : Optional.empty();
            }
        };
    }

    /** Completes the path of an act; a name without a folder is left to the acts. */
    private Optional<Completions> actFiles(String typed, List<Token> tokens, int argument) {
        return BegunFile.of(typed, tokens, argument)
                .filter(BegunFile::hasFolder)
                .map(file -> file.completions(acts::isFile));
    }

    private Completions words(String typed, List<Token> tokens, List<Member> unnamed, VisibleNames names) {
        int start = WordPlace.start(tokens, typed.length());
        tokens.removeIf(token -> token.column() > start);
        String begun = typed.substring(start).toLowerCase(Locale.ROOT);
        List<Completion> candidates = joined(candidates(tokens, unnamed, names), unlisted(tokens, begun));
        return new Completions(
                start, matching(candidates.isEmpty() ? expected(typed.substring(0, start), names) : candidates, begun));
    }

    /** Parameters that are too many to be listed, behind the first part of their names: {@code param/}. */
    private List<Completion> unlisted(List<Token> tokens, String begun) {
        int command = commandAt(tokens);
        if (begun.indexOf('/') < 0 || command != tokens.size() - 1) {
            return List.of();
        }
        Token word = tokens.get(command);
        return word.is("get") || word.is("set") || word.is("plot") || word.is("log")
                ? members(tokens.subList(0, command)).stream()
                        .flatMap(member -> member.bot().unlistedParameters(begun).stream())
                        .map(Explained::parameter)
                        .toList()
                : List.of();
    }

    private static List<Completion> matching(List<Completion> candidates, String begun) {
        TreeMap<String, Completion> words = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        candidates.stream()
                .filter(entry -> entry.text().toLowerCase(Locale.ROOT).startsWith(begun) && !entry.isHint())
                .forEach(entry -> words.putIfAbsent(entry.text(), entry));
        Stream<Completion> hints =
                candidates.stream().filter(Completion::isHint).distinct();
        return Stream.concat(words.values().stream(), hints).toList();
    }

    /** What the parser expects behind a text, if the text is right so far. */
    private List<Completion> expected(String text, VisibleNames names) {
        try {
            new LineParser(text, robotWords(), names.procedures(), new Types(null, names.kinds())).line();
            return List.of();
        } catch (ScriptException e) {
            return e.at().isEnd() && !e.expected().isEmpty() ? List.of(Explained.expected(e.expected())) : List.of();
        }
    }

    private List<String> robotWords() {
        return Stream.concat(
                        factory.types().stream().map(BotType::name),
                        team.members().stream().map(Member::name).filter(name -> !name.isEmpty()))
                .toList();
    }

    private List<Completion> candidates(List<Token> tokens, List<Member> unnamed, VisibleNames names) {
        if (tokens.isEmpty()) {
            List<Completion> first = joined(
                    joined(Explained.sessionWords(), Explained.robots(team.members())),
                    names.procedures().all().stream().map(Explained::procedure).toList());
            return unnamed.isEmpty() ? first : joined(first, Explained.commands(unnamed));
        }
        Token first = tokens.get(0);
        Optional<List<Token>> expression = Expressions.open(tokens);
        if (first.isOneOf(SessionParser.WORDS) || first.isOneOf(ScriptParser.BLOCK_WORDS)) {
            return expression
                    .map(open -> joined(
                            expressions(List.of(), names).after(open),
                            first.isOneOf(CONDITIONAL) ? conditions(List.of()).after(open) : List.of()))
                    .orElseGet(() -> afterSession(tokens, names));
        }
        if (isProcedure(tokens, names)) {
            return expression
                    .map(open -> expressions(List.of(), names).after(open))
                    .orElse(List.of());
        }
        int command = commandAt(tokens);
        List<Member> members = members(tokens.subList(0, command));
        if (command == tokens.size()) {
            return Explained.commands(members);
        }
        boolean asks = tokens.stream().anyMatch(token -> token.is("until"));
        return expression
                .map(open -> joined(
                        expressions(members, names).after(open),
                        asks ? conditions(members).after(open) : List.of()))
                .orElseGet(() -> afterCommand(tokens, command, members));
    }

    private static boolean isProcedure(List<Token> tokens, VisibleNames names) {
        boolean call = tokens.size() > 1 && tokens.get(1).kind() == Token.Kind.DOT;
        return !call && names.procedures().find(tokens.get(0)).isPresent();
    }

    private Expressions expressions(List<Member> own, VisibleNames names) {
        return new Expressions(own, team.members(), this::members, names, places.get());
    }

    private List<Completion> afterSession(List<Token> tokens, VisibleNames names) {
        boolean next = tokens.size() == 1;
        return switch (tokens.get(0).text().toLowerCase(Locale.ROOT)) {
            case "add" -> next ? addresses() : List.of(new Completion("as", "NUMBER", "gives the robot this number"));
            case "probe" -> next ? addresses() : List.of();
            case "save" ->
                next
                        ? List.of(
                                new Completion("log", "FILE", "the parameter log, as comma-separated values"),
                                new Completion("session", "FILE", "what was done, as a script that does it again"),
                                new Completion("team", "FILE", "the robots, as a script that adds them"))
                        : List.of();
            case "remove" -> Explained.robots(team.members());
            case "lab" ->
                next
                        ? List.of(
                                new Completion("place", "ROBOT X Y HEADING", "puts a robot of the lab down there"),
                                new Completion("carry", "ROBOT X Y HEADING", "does so without telling the robot"))
                        : tokens.size() == 2 ? Explained.robots(team.members()) : List.of();
            case "map" ->
                next
                        ? MAP
                        : tokens.size() == 2 && tokens.get(1).is("start")
                                ? Explained.robots(team.members())
                                : List.of();
            case "acts" -> next ? acts.completions() : List.of();
            case "trust" -> next ? joined(acts.completions(), List.of(OFF)) : List.of();
            case "help" -> next ? Help.topics().stream().map(Explained::word).toList() : List.of();
            case "let" -> next ? assignable(names) : List.of();
            case "print" -> names.values();
            case "ask" -> next ? assignable(names) : behindDefault(tokens);
            case "to" ->
                next
                        ? List.of(new Completion("", "NAME", "one word of letters, digits and _"))
                        : List.of(new Completion("", "[ARGUMENT...]", "the names of its arguments, without $"));
            case "while", "if", "on" -> conditions(List.of()).after(tokens.subList(1, tokens.size()));
            default -> List.of();
        };
    }

    /** The names that may get another value, and a hint for a new one. */
    private static List<Completion> assignable(VisibleNames names) {
        Scope<Operand> kinds = names.kinds();
        List<Completion> entries = new ArrayList<>(names.values().stream()
                .map(entry -> new Completion(entry.text().substring(1), entry.values(), entry.explanation()))
                .filter(entry -> Optional.ofNullable(kinds.find(entry.text()))
                        .filter(Operand::open)
                        .isPresent())
                .toList());
        entries.add(NAME);
        return entries;
    }

    /** What may follow the default of a question. */
    private static List<Completion> behindDefault(List<Token> tokens) {
        Token last = tokens.get(tokens.size() - 1);
        boolean awaitsValue = tokens.size() < 4 || last.isOneOf(List.of("from", "to", "or", "for"));
        if (awaitsValue) {
            return List.of();
        }
        List<Completion> words = new ArrayList<>(
                switch (tokens.get(3).kind()) {
                    case NUMBER ->
                        List.of(
                                new Completion("from", "LOWEST", "the lowest answer"),
                                new Completion("to", "HIGHEST", "the highest answer"));
                    case WORD -> List.of(new Completion("or", "WORD", "another answer"));
                    default -> List.<Completion>of();
                });
        words.removeIf(word -> !word.text().equals("or") && tokens.stream().anyMatch(token -> token.is(word.text())));
        words.add(LONGEST);
        return words;
    }

    private List<Completion> addresses() {
        List<Completion> words = new ArrayList<>();
        List<String> ports = factory.serialPorts();
        factory.types().forEach(type -> words.addAll(Explained.addresses(type, ports)));
        factory.lab().ifPresent(lab -> words.addAll(Explained.addresses(lab)));
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

    private List<Completion> afterCommand(List<Token> tokens, int command, List<Member> members) {
        List<Token> behind = tokens.subList(command + 1, tokens.size());
        List<Token> values =
                behind.stream().filter(token -> !WordPlace.separates(token)).toList();
        Token last = tokens.get(tokens.size() - 1);
        boolean names = values.isEmpty() || last.kind() == Token.Kind.COMMA || last.is("now");
        return switch (tokens.get(command).text().toLowerCase(Locale.ROOT)) {
            case "get", "help", "plot" -> names ? parameters(members, false) : List.of();
            case "log" ->
                names
                        ? joined(parameters(members, false), List.of(OFF))
                        : last.is("every") ? List.of() : List.of(new Completion("every", "TIME", "how often"));
            case "name" -> values.isEmpty() ? List.of(OFF, NAME) : List.of();
            case "set" -> values.isEmpty() ? parameters(members, true) : toSet(values, members);
            case "act" ->
                values.isEmpty() ? joined(acts.completionsFor(members), List.of(OFF)) : behindAct(behind, last);
            case "move", "turn" -> afterMotion(behind, 1, members);
            case "drive" -> afterMotion(behind, 2, members);
            case "goto" -> afterGoTo(behind, members);
            case "explore" -> afterMotion(behind, 0, members);
            default -> argument(tokens.get(command), values.size(), members);
        };
    }

    /** What may follow the name of an act: its arguments and their values, then robots. */
    private List<Completion> behindAct(List<Token> behind, Token last) {
        if (behind.stream().anyMatch(token -> token.is("with"))) {
            return last.is("with") ? Explained.robots(team.members()) : List.of();
        }
        return new ActCompletion(behind, acts::argumentsOf).entries();
    }

    /** What may follow the numbers of a motion. */
    private List<Completion> afterMotion(List<Token> behind, int numbers, List<Member> members) {
        for (int index = 0; index < behind.size(); index++) {
            if (behind.get(index).is("until")) {
                return conditions(members).after(behind.subList(index + 1, behind.size()));
            }
        }
        long typed = behind.stream()
                .filter(token -> token.kind() == Token.Kind.NUMBER)
                .count();
        boolean ended = behind.stream().anyMatch(token -> token.is("for"));
        if (typed < numbers || ended) {
            return List.of();
        }
        return numbers == 2
                ? List.of(new Completion("for", "TIME", "ends the motion after a time"), UNTIL)
                : List.of(UNTIL);
    }

    /** A place of the map or numbers, then what may end the motion. */
    private List<Completion> afterGoTo(List<Token> behind, List<Member> members) {
        if (behind.isEmpty()) {
            return places.get().stream()
                    .map(name -> Completion.word(name, "a place of the map"))
                    .toList();
        }
        boolean named = behind.get(0).kind() == Token.Kind.WORD;
        return afterMotion(behind, named ? 0 : 2, members).stream()
                .filter(offer -> !offer.text().equals("for"))
                .toList();
    }

    private Conditions conditions(List<Member> own) {
        return new Conditions(own, team.members(), this::members);
    }

    /** The values that {@code set} takes behind the parameter. */
    private static List<Completion> toSet(List<Token> values, List<Member> members) {
        Token name = values.get(0);
        int index = values.size() - 1;
        return members.stream()
                .flatMap(member -> member.bot().parameters().stream())
                .filter(parameter -> name.is(parameter.name()) && parameter.writable())
                .map(parameter -> joined(List.of(parameter), parameter.extras()))
                .flatMap(takes -> index < takes.size() ? Explained.values(takes.get(index)).stream() : Stream.empty())
                .toList();
    }

    /** The value at a place behind a command that only some robots have. */
    private static List<Completion> argument(Token name, int index, List<Member> members) {
        return members.stream()
                .flatMap(member -> member.bot().commands().stream())
                .filter(command -> name.is(command.name()))
                .map(command -> command.argument(index))
                .flatMap(argument -> argument == null ? Stream.empty() : Explained.values(argument).stream())
                .toList();
    }

    private static List<Completion> parameters(List<Member> members, boolean writable) {
        return members.stream()
                .flatMap(member -> member.bot().parameters().stream())
                .filter(parameter -> writable ? parameter.writable() : parameter.readable())
                .map(Explained::parameter)
                .toList();
    }

    private static <T> List<T> joined(List<T> some, List<T> others) {
        return Stream.concat(some.stream(), others.stream()).toList();
    }
}

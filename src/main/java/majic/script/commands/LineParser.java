package majic.script.commands;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import majic.script.run.ActCall;
import majic.script.run.Command;
import majic.script.run.Procedure;
import majic.script.run.Procedures;
import majic.script.run.Statement;
import majic.script.run.Types;
import majic.script.syntax.Condition;
import majic.script.syntax.ConditionParser;
import majic.script.syntax.Cursor;
import majic.script.syntax.Late;
import majic.script.syntax.Literal;
import majic.script.syntax.Literal.Quantity;
import majic.script.syntax.Robots;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;
import majic.text.Suggestion;
import org.jspecify.annotations.Nullable;

/**
 * Parses one line: a command for robots, as {@code 1 move 500} or {@code 1.move(500)}, or a command for the session.
 * Its methods throw a {@link ScriptException} where the line does not follow the grammar.
 */
public final class LineParser {
    /** The words of the commands that every robot has. */
    public static final List<String> COMMAND_WORDS = Help.ROBOT_WORDS;

    /** The maximum length of a line, in characters. */
    public static final int LONGEST_LINE = 4000;

    /** The message for a longer line. */
    public static final String TOO_LONG = "the line is longer than " + LONGEST_LINE + " characters";

    /** Further words that mean something in a line. */
    private static final List<String> OTHER_WORDS = List.of(
            "all",
            "and",
            "any",
            "argument",
            "as",
            "clear",
            "every",
            "for",
            "me",
            "no",
            "not",
            "now",
            "off",
            "on",
            "or",
            "until",
            "with",
            "yes");

    private final Cursor at;
    private final Collection<String> robotWords;
    private final Procedures procedures;
    private boolean inCall;

    /**
     * A parser for one line.
     *
     * @param line the line
     * @param robotWords the words that stand for robots: types, names
     */
    public LineParser(String line, Collection<String> robotWords) {
        this(line, robotWords, new Procedures(), new Types(null));
    }

    /**
     * A parser for one line behind others.
     *
     * @param procedures those that it may call
     * @param types what is known of the names that it may use; a name of the line is added
     */
    public LineParser(String line, Collection<String> robotWords, Procedures procedures, Types types) {
        this(new Cursor(Scanner.scan(line), 0, types), robotWords, procedures);
    }

    /** A parser for lines of a script; each starts where the cursor is. */
    LineParser(Cursor at, Collection<String> robotWords, Procedures procedures) {
        this.procedures = procedures;
        this.at = at;
        this.robotWords = new HashSet<>();
        robotWords.forEach(word -> this.robotWords.add(word.toLowerCase(Locale.ROOT)));
    }

    /** Whether there is nothing but blanks and a comment. */
    public boolean isBlank() {
        return at.peek().isEnd();
    }

    /** Whether the line begins a block, continues it with {@code else}, or ends it. */
    public boolean isBlockLine() {
        return at.peek().isOneOf(ScriptParser.BLOCK_WORDS);
    }

    /**
     * Returns the word that the line begins with; empty for a line that begins otherwise, with a number for instance.
     */
    public Optional<String> firstWord() {
        return at.check(Kind.WORD) ? Optional.of(at.peek().text().toLowerCase(Locale.ROOT)) : Optional.empty();
    }

    /** Whether the second token begins the arguments of a call, as in {@code move(500)}. */
    public boolean isCallWithoutRobots() {
        return at.peekSecond().kind() == Kind.LEFT;
    }

    /**
     * Parses the line: {@code line = sessionCommand | place | procedureCall | robots ( command | call ) ;}. One with a
     * value that is not known before it runs is parsed again then.
     */
    public Statement line() {
        Token first = at.peek();
        int start = at.place();
        Statement line = lineNow();
        if (!at.isOpenSince(start)) {
            return line;
        }
        Collection<String> words = Set.copyOf(robotWords);
        return new Statement.Computed(
                first, Late.again(at, start, line, cursor -> new LineParser(cursor, words, procedures).lineNow()));
    }

    private Statement lineNow() {
        Token first = at.peek();
        if (first.is("argument")) {
            throw new ScriptException(
                    first, first.text() + ": only a script file has arguments, in front of all its other lines");
        }
        Statement statement = statement(first);
        at.endOfLine();
        return statement;
    }

    private Statement statement(Token first) {
        if (first.is("lab") && at.peekSecond().isOneOf(List.of("place", "carry"))) {
            return place(first);
        }
        Optional<Procedure> procedure = first.kind() == Kind.WORD ? procedures.find(first) : Optional.empty();
        if (procedure.isPresent() && at.peekSecond().kind() != Kind.DOT) {
            return procedureCall(at.advance(), procedure.get());
        }
        return first.isOneOf(SessionParser.WORDS)
                ? new Statement.ForSession(first, new SessionParser(at).sessionCommand())
                : forRobots(first);
    }

    /** {@code place = "lab" ( "place" | "carry" ) robots DISTANCE DISTANCE ANGLE ;} */
    private Statement place(Token first) {
        at.advance();
        Token word = at.advance();
        Robots robots = Robots.parse(at);
        Literal x = at.number(Quantity.DISTANCE);
        Literal y = at.number(Quantity.DISTANCE);
        return new Statement.ForRobots(first, robots, new LabCommands.Place(word, x, y, at.number(Quantity.ANGLE)));
    }

    private Statement forRobots(Token first) {
        requireRobots(first);
        Robots robots = Robots.parse(at);
        Command command;
        try {
            at.setOwnRobots(robots);
            command = at.match(Kind.DOT) ? call() : command();
        } finally {
            at.setOwnRobots(null);
            inCall = false;
        }
        return robots.isAll() && command instanceof MotionCommands.Stop
                ? new Statement.ForSession(first, new TeamCommands.StopAll())
                : new Statement.ForRobots(first, robots, command);
    }

    /** {@code procedureCall = NAME { value } ;} with a value for each argument. */
    private Statement procedureCall(Token word, Procedure procedure) {
        List<Literal> given = new ArrayList<>();
        for (Token argument : procedure.arguments()) {
            if (at.peek().isEnd()) {
                throw at.unexpected("a value for " + argument.text() + " (" + procedure + ")");
            }
            given.add(at.value("a value for " + argument.text(), false));
        }
        if (!at.peek().isEnd()) {
            throw new ScriptException(
                    at.peek(), at.peek().written() + ": nothing more is expected here (" + procedure + ")");
        }
        return new Statement.Call(word, procedure, List.copyOf(given));
    }

    /** A word that cannot be a robot gets a better message than that a command is missing behind it. */
    private void requireRobots(Token first) {
        if (first.kind() != Kind.WORD) {
            return;
        }
        String word = first.text().toLowerCase(Locale.ROOT);
        if (COMMAND_WORDS.contains(word)) {
            throw new ScriptException(
                    first, first.text() + ": which robot? Write its number in front, as in \"1 " + word + "\"");
        }
        if (!word.equals("all") && !word.equals("me") && !robotWords.contains(word)) {
            throw new ScriptException(
                    first,
                    first.text() + ": no such command or robot" + Suggestion.didYouMean(first.text(), firstWords()));
        }
    }

    private Collection<String> firstWords() {
        Collection<String> words = new TreeSet<>(SessionParser.WORDS);
        words.addAll(ScriptParser.BLOCK_WORDS);
        words.addAll(robotWords);
        words.add("all");
        words.addAll(procedures.names());
        return words;
    }

    /** {@code call = "." WORD "(" arguments ")" ;} with the arguments of that command. */
    private Command call() {
        Token word = at.consume(Kind.WORD, "a command");
        at.consume(Kind.LEFT, "\"(\"");
        inCall = true;
        Command command = arguments(word);
        at.consume(Kind.RIGHT, "\")\"");
        return command;
    }

    /**
     * {@code command = move | turn | drive | goto | explore | stop | get | set | log | plot | name | act | wait |
     * localize | help | own ;}
     */
    private Command command() {
        return arguments(at.consume(Kind.WORD, "a command"));
    }

    private Command arguments(Token word) {
        return switch (word.text().toLowerCase(Locale.ROOT)) {
            case "move" -> move(word);
            case "turn" -> turn(word);
            case "drive" -> drive(word);
            case "goto" -> goTo(word);
            case "explore" -> new MotionCommands.Explore(word, until());
            case "stop" -> new MotionCommands.Stop(word);
            case "get" -> get(word);
            case "set" -> set(word);
            case "log" -> log(word);
            case "plot" -> new ParameterCommands.Plot(word, parameters());
            case "name" -> name(word);
            case "act" -> act(word);
            case "wait" -> new WaitCommands.AwaitRobots(word);
            case "localize" -> new MapCommands.Localize(word);
            case "help" -> help(word);
            default -> own(word);
        };
    }

    /** {@code move = "move" DISTANCE [ until ] ;} */
    private Command move(Token word) {
        return new MotionCommands.Move(word, at.number(Quantity.DISTANCE), until());
    }

    /** {@code turn = "turn" ANGLE [ until ] ;} */
    private Command turn(Token word) {
        return new MotionCommands.Turn(word, at.number(Quantity.ANGLE), until());
    }

    /** {@code drive = "drive" SPEED TURNRATE [ "for" TIME | until ] ;} */
    private Command drive(Token word) {
        Literal speed = at.number(Quantity.SPEED);
        separator();
        Literal rate = at.number(Quantity.TURN_RATE);
        separator();
        OptionalDouble seconds =
                at.match("for") ? OptionalDouble.of(at.number(Quantity.TIME).number()) : OptionalDouble.empty();
        return new MotionCommands.Drive(word, speed, rate, seconds, seconds.isPresent() ? null : until());
    }

    /** {@code goto = "goto" ( NAME | DISTANCE DISTANCE [ ANGLE ] ) [ until ] ;} */
    private Command goTo(Token word) {
        at.fillIn();
        if (at.check(Kind.WORD)) {
            return new MotionCommands.GoTo(word, at.advance(), List.of(), until());
        }
        List<Literal> numbers = new ArrayList<>();
        numbers.add(at.number(Quantity.DISTANCE));
        separator();
        numbers.add(at.number(Quantity.DISTANCE));
        separator();
        if (at.check(Kind.NUMBER) || at.startsComputed()) {
            numbers.add(at.number(Quantity.ANGLE));
        }
        return new MotionCommands.GoTo(word, null, List.copyOf(numbers), until());
    }

    /** {@code until = "until" condition ;} */
    private @Nullable Condition until() {
        separator();
        return at.match("until") ? new ConditionParser(at).condition() : null;
    }

    /** {@code get = "get" [ "now" ] parameters ;} */
    private Command get(Token word) {
        boolean now = at.match("now");
        return new ParameterCommands.Get(word, parameters(), now);
    }

    /** {@code parameters = PARAMETER { "," PARAMETER } ;} */
    private List<Token> parameters() {
        List<Token> names = new ArrayList<>();
        do {
            names.add(at.consume(Kind.WORD, "a parameter"));
        } while (at.match(Kind.COMMA));
        return names;
    }

    /** {@code set = "set" PARAMETER value { value } ;} */
    private Command set(Token word) {
        Token parameter = at.consume(Kind.WORD, "a parameter");
        separator();
        List<Literal> values = new ArrayList<>();
        values.add(at.value("a value", inCall));
        values.addAll(values());
        return new ParameterCommands.Set(word, parameter, values);
    }

    /** {@code log = "log" ( "off" | parameters "every" TIME ) ;} */
    private Command log(Token word) {
        if (at.match("off")) {
            return new ParameterCommands.LogOff(word);
        }
        List<Token> names = parameters();
        separator();
        if (!at.match("every")) {
            throw at.unexpected("\"every\" and a time");
        }
        return new ParameterCommands.Log(word, names, at.number(Quantity.TIME));
    }

    /** {@code name = "name" [ "off" | NAME ] ;} The lines behind it may use the name. */
    private Command name(Token word) {
        if (at.peek().isEnd() || at.check(Kind.RIGHT)) {
            return new TeamCommands.Name(word, null);
        }
        Token name = at.consume(Kind.WORD, "a name, one word,");
        if (!name.is("off")) {
            requireName(name);
            robotWords.add(name.text().toLowerCase(Locale.ROOT));
        }
        return new TeamCommands.Name(word, name);
    }

    private static void requireName(Token name) {
        if (isOfLanguage(name)) {
            throw new ScriptException(
                    name, name.text() + ": a word of MAJIC Script cannot be the name of a robot; take another word");
        }
    }

    private static boolean isOfLanguage(Token name) {
        return Stream.of(SessionParser.WORDS, ScriptParser.BLOCK_WORDS, COMMAND_WORDS, OTHER_WORDS)
                .anyMatch(name::isOneOf);
    }

    /** Checks that a procedure may have a name. */
    void requireProcedureName(Token name) {
        if (isOfLanguage(name) || robotWords.contains(name.text().toLowerCase(Locale.ROOT))) {
            throw new ScriptException(
                    name,
                    name.text()
                            + ": a word of MAJIC Script or a robot has that name; take another one for the procedure");
        }
    }

    /** {@code act = "act" ( "off" | NAME { argument } [ "with" robots ] ) ;} */
    private Command act(Token word) {
        if (at.match("off")) {
            return new ActCommands.ActOff(word);
        }
        Literal name = at.value("an act's name", inCall);
        List<ActCall.Given> given = new ArrayList<>();
        separator();
        while (isArgument()) {
            given.add(argument());
            separator();
        }
        Robots others = at.match("with") ? Robots.parse(at) : null;
        if (others != null && isArgument()) {
            throw new ScriptException(at.peek(), at.peek().text() + ": write arguments in front of \"with\"");
        }
        return new ActCommands.Act(word, new ActCall(name, given, others));
    }

    private boolean isArgument() {
        return at.check(Kind.WORD) && at.peekSecond().kind() == Kind.OPERATOR;
    }

    /** {@code argument = WORD "=" value ;} */
    private ActCall.Given argument() {
        Token name = at.advance();
        at.equalsSign("=");
        return new ActCall.Given(name, at.value("a value for " + name.text(), inCall));
    }

    /** {@code help = "help" [ PARAMETER ] ;} */
    private Command help(Token word) {
        return new HelpCommands.RobotHelp(word, at.check(Kind.WORD) ? at.advance() : null);
    }

    /** {@code own = WORD { value } ;} */
    private Command own(Token word) {
        return new ParameterCommands.Own(word, values());
    }

    /** {@code value = NUMBER | WORD | QUOTED | TOGETHER ;} */
    private List<Literal> values() {
        List<Literal> values = new ArrayList<>();
        separator();
        while (!at.peek().isEnd() && !(inCall && at.check(Kind.RIGHT))) {
            values.add(at.value("a value", inCall));
            separator();
        }
        return values;
    }

    private void separator() {
        if (inCall) {
            at.match(Kind.COMMA);
        }
    }
}

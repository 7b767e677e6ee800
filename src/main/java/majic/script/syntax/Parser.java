package majic.script.syntax;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeSet;
import java.util.function.Supplier;
import majic.script.syntax.Token.Kind;
import majic.text.Suggestion;

/**
 * Makes a tree out of tokens: scripts, blocks and lines. After a mistake it goes on with the next line, so that all are
 * found together.
 */
public final class Parser {
    /** Words that begin blocks or end them. */
    public static final List<String> BLOCK_WORDS = List.of("else", "end", "if", "repeat", "while");

    private static final int DEEPEST = 50;

    private final Cursor at;
    private final Collection<String> types;
    private final List<Mistake> mistakes = new ArrayList<>();
    private final ConditionParser conditions;
    private final SessionParser session;
    private final RobotsParser robots;
    private final CommandParser commands;
    private int depth;

    /**
     * A parser for one text.
     *
     * @param tokens all of it
     * @param types the words for types of robots
     */
    public Parser(List<Token> tokens, Collection<String> types) {
        this.at = new Cursor(tokens);
        this.types = types;
        this.conditions = new ConditionParser(at);
        this.session = new SessionParser(at);
        this.robots = new RobotsParser(at);
        this.commands = new CommandParser(at);
    }

    /** What was found wrong so far, in the order of the text. */
    public List<Mistake> mistakes() {
        return mistakes;
    }

    /** Reads a whole script: {@code script = lines ;}. */
    public List<Statement> script() {
        List<Statement> statements = new ArrayList<>(lines());
        while (!at.check(Kind.END)) {
            Token stray = at.peek();
            mistakes.add(new ScriptException(stray, stray.text() + ": no block is open here").mistake());
            at.toNextLine();
            statements.addAll(lines());
        }
        return statements;
    }

    /** {@code lines = { [ statement ] NEWLINE } ;} up to what ends a block. */
    private List<Statement> lines() {
        List<Statement> statements = new ArrayList<>();
        while (!at.check(Kind.END) && !at.check("end") && !at.check("else")) {
            try {
                if (!at.match(Kind.NEWLINE)) {
                    statements.add(statement());
                }
            } catch (ScriptException e) {
                mistakes.add(e.mistake());
                at.toNextLine();
            }
        }
        return statements;
    }

    /** {@code statement = repeat | while | if | line ;} */
    private Statement statement() {
        if (at.check("repeat")) {
            return nested(this::repeat);
        }
        if (at.check("while")) {
            return nested(this::whileLoop);
        }
        return at.check("if") ? nested(this::choice) : line();
    }

    private Statement nested(Supplier<Statement> block) {
        if (++depth > DEEPEST) {
            throw new ScriptException(at.peek(), "blocks are nested too deeply");
        }
        try {
            return block.get();
        } finally {
            depth--;
        }
    }

    /** {@code repeat = "repeat" [ NUMBER ] NEWLINE lines "end" ;} */
    private Statement repeat() {
        Token word = at.peek();
        OptionalInt times = head(this::times, OptionalInt.empty());
        return new Statement.Repeat(word, times, body(word));
    }

    private OptionalInt times() {
        at.advance();
        if (at.peek().isEnd()) {
            return OptionalInt.empty();
        }
        Token number = at.peek();
        int times = at.count("how often, a whole number,");
        if (times < 0) {
            throw new ScriptException(number, number.text() + ": nothing can be repeated less than 0 times");
        }
        at.endOfLine();
        return OptionalInt.of(times);
    }

    /** {@code while = "while" condition NEWLINE lines "end" ;} */
    private Statement whileLoop() {
        Token word = at.peek();
        Optional<Condition> condition = condition();
        List<Statement> body = body(word);
        return condition.isPresent() ? new Statement.While(word, condition.get(), body) : once(word, body);
    }

    /** {@code if = "if" condition NEWLINE lines [ "else" NEWLINE lines ] "end" ;} */
    private Statement choice() {
        Token word = at.peek();
        Optional<Condition> condition = condition();
        List<Statement> then = lines();
        List<Statement> otherwise = List.of();
        if (at.match("else")) {
            endOfElse();
            otherwise = body(word);
        } else {
            end(word);
        }
        if (condition.isPresent()) {
            return new Statement.If(word, condition.get(), then, otherwise);
        }
        then.addAll(otherwise);
        return once(word, then);
    }

    private Optional<Condition> condition() {
        return head(() -> Optional.of(asked()), Optional.empty());
    }

    /** Stands for a block whose head could not be read, so that its body can still be checked; it is never run. */
    private static Statement once(Token word, List<Statement> body) {
        return new Statement.Repeat(word, OptionalInt.of(1), body);
    }

    private Condition asked() {
        Token word = at.advance();
        Condition condition = conditions.condition();
        at.endOfLine();
        return condition;
    }

    private List<Statement> body(Token head) {
        List<Statement> body = lines();
        while (at.check("else")) {
            mistakes.add(new ScriptException(at.peek(), "else: there is no if in front of it").mistake());
            at.toNextLine();
            body.addAll(lines());
        }
        end(head);
        return body;
    }

    private void end(Token head) {
        if (!at.match("end")) {
            throw new ScriptException(head, head.text() + ": its \"end\" is missing");
        }
        at.endOfLine();
    }

    private void endOfElse() {
        head(
                () -> {
                    at.endOfLine();
                    return true;
                },
                false);
    }

    /** The head of a block; when it is wrong its body is still looked at. */
    private <T> T head(Supplier<T> rule, T instead) {
        try {
            return rule.get();
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
            at.toNextLine();
            return instead;
        }
    }

    /** {@code line = sessionCommand | robots ( command | call ) ;} */
    private Statement line() {
        Token first = at.peek();
        Statement statement =
                session.begins() ? new Statement.ForSession(first, session.sessionCommand()) : forRobots(first);
        at.endOfLine();
        return statement;
    }

    private Statement forRobots(Token first) {
        requireRobots(first);
        Robots who = robots.robots();
        Command command = at.check(Kind.DOT) ? commands.call() : commands.command();
        return who.isAll() && command instanceof Command.Stop
                ? new Statement.ForSession(first, new SessionCommand.StopAll())
                : new Statement.ForRobots(first, who, command);
    }

    /** A word that cannot be a robot gets a better message than that a command is missing behind it. */
    private void requireRobots(Token first) {
        if (first.kind() != Kind.WORD) {
            return;
        }
        String word = first.text().toLowerCase(Locale.ROOT);
        if (CommandParser.WORDS.contains(word)) {
            throw new ScriptException(
                    first, first.text() + ": which robot? Write its number in front, as in \"1 " + word + "\"");
        }
        if (!word.equals("all") && !word.equals("me") && !types.contains(word)) {
            throw new ScriptException(
                    first, first.text() + ": no such command" + Suggestion.didYouMean(first.text(), firstWords()));
        }
    }

    private Collection<String> firstWords() {
        Collection<String> words = new TreeSet<>(SessionParser.WORDS);
        words.addAll(BLOCK_WORDS);
        words.addAll(types);
        words.add("all");
        return words;
    }

    /** One line of a block that is still being typed. */
    public Piece piece() {
        Token first = at.peek();
        try {
            return switch (first.kind() == Kind.WORD ? first.text().toLowerCase(Locale.ROOT) : "") {
                case "repeat" -> new Piece.Open(first, new Statement.Repeat(first, times(), List.of()));
                case "while" -> new Piece.Open(first, new Statement.While(first, asked(), List.of()));
                case "if" -> new Piece.Open(first, new Statement.If(first, asked(), List.of(), List.of()));
                case "else" -> only(new Piece.Otherwise(at.advance()));
                case "end" -> only(new Piece.Close(at.advance()));
                default -> first.isEnd() ? new Piece.Nothing(first) : new Piece.Plain(first, line());
            };
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
            return new Piece.Nothing(first);
        }
    }

    private Piece only(Piece piece) {
        at.endOfLine();
        return piece;
    }
}

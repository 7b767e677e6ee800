package majic.script.commands;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import majic.bot.Value;
import majic.script.run.Statement;
import majic.script.syntax.Condition;
import majic.script.syntax.ConditionParser;
import majic.script.syntax.Cursor;
import majic.script.syntax.Mistake;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;

/**
 * Parses scripts: lines and blocks of lines. After a mistake it continues with the next line, so that all mistakes are
 * found in one run.
 */
public final class ScriptParser {
    /** Words that begin blocks or end them. */
    public static final List<String> BLOCK_WORDS = List.of("else", "end", "if", "repeat", "while");

    private static final Pattern LINE_BREAK = Pattern.compile("\\R");
    private static final int DEEPEST = 50;

    private final Cursor at;
    private final LineParser lines;
    private final List<Mistake> mistakes;
    private int depth;

    private ScriptParser(String text, Collection<String> robotWords, List<Mistake> mistakes) {
        this.at = new Cursor(Scanner.scan(text));
        this.lines = new LineParser(at, robotWords);
        this.mistakes = mistakes;
    }

    /**
     * Parses a script whose arguments have their defaults; checks nothing that depends on robots.
     *
     * @param robotWords the words that stand for robots: types, names
     * @param mistakes receives what is wrong, in the order of the text
     */
    public static List<Statement> parse(String text, Collection<String> robotWords, List<Mistake> mistakes) {
        return parse(text, robotWords, Map.of(), mistakes);
    }

    /**
     * Parses a script as the other method does.
     *
     * @param given the values of arguments by name in lower case; an argument without one has its default
     */
    public static List<Statement> parse(
            String text, Collection<String> robotWords, Map<String, Value> given, List<Mistake> mistakes) {
        String[] lines = LINE_BREAK.split(text, -1);
        for (int index = 0; index < lines.length; index++) {
            if (lines[index].length() > LineParser.LONGEST_LINE) {
                mistakes.add(new Mistake(index + 1, 1, LineParser.TOO_LONG));
                return List.of();
            }
        }
        return new ScriptParser(text, robotWords, mistakes).script(given);
    }

    /** {@code script = { argument } lines ;} */
    private List<Statement> script(Map<String, Value> given) {
        List<Statement> statements = new ArrayList<>(arguments(new ArgumentParser(at, given)));
        statements.addAll(lines());
        while (!at.check(Kind.END)) {
            Token stray = at.peek();
            mistakes.add(new ScriptException(stray, stray.text() + ": no block is open here").mistake());
            at.toNextLine();
            statements.addAll(lines());
        }
        return statements;
    }

    private List<Statement> arguments(ArgumentParser parser) {
        List<Statement> arguments = new ArrayList<>();
        while (at.check(Kind.NEWLINE) || at.check("argument")) {
            try {
                if (!at.match(Kind.NEWLINE)) {
                    arguments.add(parser.argument());
                }
            } catch (ScriptException e) {
                mistakes.add(e.mistake());
                at.toNextLine();
            }
        }
        return arguments;
    }

    /** {@code lines = { [ statement ] NEWLINE } ;} up to the end of the block or the script. */
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
        return at.check("if") ? nested(this::choice) : lines.line();
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
            endOfWord();
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

    /** Stands for a block whose head could not be parsed, so that its body can still be checked; it is never run. */
    private static Statement once(Token word, List<Statement> body) {
        return new Statement.Repeat(word, OptionalInt.of(1), body);
    }

    private Condition asked() {
        at.advance();
        Condition condition = new ConditionParser(at).condition();
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

    /** A block whose end is missing or wrong is kept, so that the lines in it are checked. */
    private void end(Token head) {
        if (at.match("end")) {
            endOfWord();
        } else {
            mistakes.add(new ScriptException(head, head.text() + ": its \"end\" is missing").mistake());
        }
    }

    private void endOfWord() {
        head(
                () -> {
                    at.endOfLine();
                    return true;
                },
                false);
    }

    /** Parses the head of a block; after a mistake in it the body is parsed as well. */
    private <T> T head(Supplier<T> rule, T instead) {
        try {
            return rule.get();
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
            at.toNextLine();
            return instead;
        }
    }

    /**
     * Parses a line that begins a block, continues it with {@code else}, or ends it, without the rest of the block.
     *
     * @param line begins with one of {@link #BLOCK_WORDS}
     * @return the head of the block, without a body; empty for {@code else} and {@code end}
     * @throws ScriptException if the line does not follow the grammar
     */
    public static Optional<Statement> blockLine(String line) {
        return new ScriptParser(line, List.of(), List.of()).blockLine();
    }

    private Optional<Statement> blockLine() {
        Token word = at.peek();
        if (word.is("repeat")) {
            return Optional.of(new Statement.Repeat(word, times(), List.of()));
        }
        if (word.is("while")) {
            return Optional.of(new Statement.While(word, asked(), List.of()));
        }
        if (word.is("if")) {
            return Optional.of(new Statement.If(word, asked(), List.of(), List.of()));
        }
        at.advance();
        at.endOfLine();
        return Optional.empty();
    }
}

package majic.script.commands;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import majic.bot.Value;
import majic.script.run.Procedure;
import majic.script.run.Procedures;
import majic.script.run.Scope;
import majic.script.run.Statement;
import majic.script.run.Types;
import majic.script.syntax.Condition;
import majic.script.syntax.ConditionParser;
import majic.script.syntax.Cursor;
import majic.script.syntax.Late;
import majic.script.syntax.Mistake;
import majic.script.syntax.Operand;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;
import org.jspecify.annotations.Nullable;

/**
 * Parses scripts: lines and blocks of lines. After a mistake it continues with the next line, so that all mistakes are
 * found in one run.
 */
public final class ScriptParser {
    /** Words that begin blocks or end them. */
    public static final List<String> BLOCK_WORDS = List.of("else", "end", "if", "on", "repeat", "to", "while");

    private static final Pattern LINE_BREAK = Pattern.compile("\\R");
    private static final int DEEPEST = 50;

    private final Cursor at;
    private final LineParser lines;
    private final Types types;
    private final Procedures procedures;
    private final List<Mistake> mistakes;
    private int depth;
    private @Nullable Scope<Operand> namesAtEnd;

    private ScriptParser(
            String text, Collection<String> robotWords, Procedures procedures, Types types, List<Mistake> mistakes) {
        this.at = new Cursor(Scanner.scan(text), 0, types);
        this.procedures = procedures;
        this.lines = new LineParser(at, robotWords, procedures);
        this.types = types;
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
        return parse(text, robotWords, given, new Procedures(), new Types(null), mistakes);
    }

    /**
     * Parses a block of a prompt as the other methods do.
     *
     * @param procedures those that it may call; those that it has are added
     * @param types what is known of the names that it may use
     */
    public static List<Statement> parse(
            String text, Collection<String> robotWords, Procedures procedures, Types types, List<Mistake> mistakes) {
        return parse(text, robotWords, Map.of(), procedures, types, mistakes);
    }

    /**
     * Returns what is known of the names that a line behind a text may use, inside the blocks that are open there.
     *
     * @param text the beginning of a script; wrong lines in it are left out
     * @param procedures those that it may call
     * @param types what is known of the robots
     */
    public static Scope<Operand> namesBehind(String text, Procedures procedures, Types types) {
        ScriptParser parser = new ScriptParser(text, List.of(), procedures.copy(), types, new ArrayList<>());
        parser.script(Map.of());
        Scope<Operand> names = parser.namesAtEnd;
        return names == null ? types.scope() : names;
    }

    private static List<Statement> parse(
            String text,
            Collection<String> robotWords,
            Map<String, Value> given,
            Procedures procedures,
            Types types,
            List<Mistake> mistakes) {
        String[] lines = LINE_BREAK.split(text, -1);
        for (int index = 0; index < lines.length; index++) {
            if (lines[index].length() > LineParser.LONGEST_LINE) {
                mistakes.add(new Mistake(index + 1, 1, LineParser.TOO_LONG));
                return List.of();
            }
        }
        return new ScriptParser(text, robotWords, procedures, types, mistakes).script(given);
    }

    /** {@code script = { argument } lines ;} */
    private List<Statement> script(Map<String, Value> given) {
        findProcedures();
        List<Statement> statements = new ArrayList<>(arguments(new ArgumentParser(at, types, given)));
        statements.addAll(lines());
        while (!at.check(Kind.END)) {
            Token stray = at.peek();
            mistakes.add(new ScriptException(stray, stray.text() + ": no block is open here").mistake());
            at.toNextLine();
            statements.addAll(lines());
        }
        return statements;
    }

    /** Makes the procedures known, so that the lines in front of one may call it too. */
    private void findProcedures() {
        Set<String> found = new HashSet<>();
        for (Cursor head : at.behindFirst("to")) {
            try {
                Procedure procedure = procedureHead(head);
                if (!found.add(procedure.name().text().toLowerCase(Locale.ROOT))) {
                    throw new ScriptException(
                            procedure.name(), procedure.name().text() + ": there is a procedure of that name already");
                }
                procedures.add(procedure);
            } catch (ScriptException e) {
                mistakes.add(e.mistake());
            }
        }
    }

    /** {@code procedure = "to" NAME { NAME } NEWLINE lines "end" ;} */
    private Procedure procedureHead(Cursor head) {
        Token name = ArgumentParser.name(head, "a name for the procedure");
        lines.requireProcedureName(name);
        List<Token> arguments = new ArrayList<>();
        while (!head.peek().isEnd()) {
            Token argument = ArgumentParser.name(head, "the name of an argument");
            if (arguments.stream().anyMatch(other -> other.text().equalsIgnoreCase(argument.text()))) {
                throw new ScriptException(argument, argument.text() + ": there is an argument of that name already");
            }
            arguments.add(argument);
        }
        return new Procedure(name, arguments);
    }

    /** The head was parsed before; a wrong one is not reported again. */
    private Statement procedure() {
        Token word = at.advance();
        Optional<Procedure> found = procedures.find(at.peek());
        Procedure procedure = found.orElseGet(() -> new Procedure(word, List.of()));
        at.toNextLine();
        types.inProcedure(() -> {
            procedure.arguments().forEach(argument -> types.argument(argument, Operand.ANY));
            procedure.setBody(body(word));
        });
        if (depth > 1) {
            throw new ScriptException(word, word.text() + ": a procedure stands outside of all blocks");
        }
        return new Statement.ProcedureDefinition(word, procedure);
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
        if (at.check(Kind.END) && namesAtEnd == null) {
            namesAtEnd = types.scope().copy();
        }
        return statements;
    }

    /** {@code statement = repeat | while | if | on | procedure | line ;} */
    private Statement statement() {
        if (at.check("repeat")) {
            return nested(this::repeat);
        }
        if (at.check("while")) {
            return nested(this::whileLoop);
        }
        if (at.check("on")) {
            return nested(this::on);
        }
        if (at.check("to")) {
            return nested(this::procedure);
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
        Late<OptionalInt> times = head(ScriptParser::times, OptionalInt.empty());
        return new Statement.Repeat(word, times, body(word));
    }

    private static OptionalInt times(Cursor at) {
        at.advance();
        if (at.peek().isEnd()) {
            return OptionalInt.empty();
        }
        int times = at.count("how often, a whole number,");
        if (times < 0) {
            Token number = at.previous();
            throw new ScriptException(number, number.text() + ": nothing can be repeated less than 0 times");
        }
        at.endOfLine();
        return OptionalInt.of(times);
    }

    /** {@code while = "while" condition NEWLINE lines "end" ;} */
    private Statement whileLoop() {
        Token word = at.peek();
        Optional<Late<Condition>> condition = condition();
        List<Statement> body = body(word);
        return condition.isPresent() ? new Statement.While(word, condition.get(), body) : once(word, body);
    }

    /** {@code on = "on" condition NEWLINE lines "end" ;} */
    private Statement on() {
        Token word = at.peek();
        Optional<Late<Condition>> condition = condition();
        List<Statement> body = body(word);
        return condition.isPresent() ? new Statement.On(word, condition.get(), body) : once(word, body);
    }

    /** {@code if = "if" condition NEWLINE lines [ "else" NEWLINE lines ] "end" ;} */
    private Statement choice() {
        Token word = at.peek();
        Optional<Late<Condition>> condition = condition();
        List<Statement> then = block();
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

    private Optional<Late<Condition>> condition() {
        int before = mistakes.size();
        Late<Optional<Condition>> asked = head(cursor -> Optional.of(asked(cursor)), Optional.empty());
        return mistakes.size() == before ? Optional.of(asked.map(Optional::orElseThrow)) : Optional.empty();
    }

    /** Stands for a block whose head could not be parsed, so that its body can still be checked; it is never run. */
    private static Statement once(Token word, List<Statement> body) {
        return new Statement.Repeat(word, Late.of(OptionalInt.of(1)), body);
    }

    private static Condition asked(Cursor at) {
        at.advance();
        Condition condition = new ConditionParser(at).condition();
        at.endOfLine();
        return condition;
    }

    /** The lines of a block, whose own names end with it. */
    private List<Statement> block() {
        types.begin();
        List<Statement> statements = lines();
        types.end();
        return statements;
    }

    private List<Statement> body(Token head) {
        List<Statement> body = block();
        while (at.check("else")) {
            mistakes.add(new ScriptException(at.peek(), "else: there is no if in front of it").mistake());
            at.toNextLine();
            body.addAll(block());
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
                cursor -> {
                    cursor.endOfLine();
                    return true;
                },
                false);
    }

    /** Parses the head of a block; after a mistake in it the body is parsed as well. */
    private <T> Late<T> head(Function<Cursor, T> rule, T instead) {
        try {
            return Late.parse(at, rule);
        } catch (ScriptException e) {
            mistakes.add(e.mistake());
            at.toNextLine();
            return Late.of(instead);
        }
    }

    /**
     * Parses a line that begins a block, continues it with {@code else}, or ends it, without the rest of the block.
     *
     * @param line begins with one of {@link #BLOCK_WORDS}
     * @param types what is known of the names that it may use
     * @return the head of the block, without a body; empty for {@code else} and {@code end}
     * @throws ScriptException if the line does not follow the grammar
     */
    public static Optional<Statement> blockLine(String line, Types types) {
        return new ScriptParser(line, List.of(), new Procedures(), types, List.of()).blockLine();
    }

    private Optional<Statement> blockLine() {
        Token word = at.peek();
        if (word.is("repeat")) {
            return Optional.of(new Statement.Repeat(word, Late.parse(at, ScriptParser::times), List.of()));
        }
        if (word.is("while")) {
            return Optional.of(new Statement.While(word, Late.parse(at, ScriptParser::asked), List.of()));
        }
        if (word.is("if")) {
            return Optional.of(new Statement.If(word, Late.parse(at, ScriptParser::asked), List.of(), List.of()));
        }
        if (word.is("on")) {
            return Optional.of(new Statement.On(word, Late.parse(at, ScriptParser::asked), List.of()));
        }
        at.advance();
        if (word.is("to")) {
            return Optional.of(new Statement.ProcedureDefinition(word, procedureHead(at)));
        }
        at.endOfLine();
        return Optional.empty();
    }
}

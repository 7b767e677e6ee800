package majic.script;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.Value;
import majic.script.commands.LineParser;
import majic.script.commands.ScriptParser;
import majic.script.commands.TeamCommands;
import majic.script.help.PromptNames;
import majic.script.help.VisibleNames;
import majic.script.lines.Dispatcher;
import majic.script.lines.LineSource;
import majic.script.lines.PreparedLine;
import majic.script.run.CommandTrait;
import majic.script.run.Procedures;
import majic.script.run.Scope;
import majic.script.run.Statement;
import majic.script.run.Types;
import majic.script.syntax.Mistake;
import majic.script.syntax.Operand;
import org.jspecify.annotations.Nullable;

/**
 * Parses and checks the lines of one {@link MajicParser}, and keeps those of an open block until its {@code end}.
 * Submits nothing. Thread-safe.
 */
final class LineChecker {
    private final Supplier<Collection<String>> sessionWords;
    private final LineSource source;
    private final Dispatcher dispatcher;
    private final Set<String> givenNames = ConcurrentHashMap.newKeySet();
    private final Procedures procedures = new Procedures();
    private final Scope<Operand> promptNames = new Scope<>();
    private final Types promptTypes = new Types(null, promptNames);
    private @Nullable TypedBlock block;
    private @Nullable Types blockTypes;
    private @Nullable Procedures blockProcedures;

    /**
     * What a line lets be done now.
     *
     * @param lines nothing while a block is open
     * @param text the line, or all lines of the block
     */
    record Accepted(List<PreparedLine> lines, String text) {}

    /**
     * No line yet.
     *
     * @param sessionWords the words that stand for robots of the session, in a new collection
     */
    LineChecker(Supplier<Collection<String>> sessionWords, LineSource source, Dispatcher dispatcher) {
        this.sessionWords = sessionWords;
        this.source = source;
        this.dispatcher = dispatcher;
    }

    /** Parses and checks a line. Waits for no file and no robot, since it holds the lock. */
    synchronized Accepted accept(String line) {
        if (line.length() > LineParser.LONGEST_LINE) {
            throw new BotException(LineParser.TOO_LONG);
        }
        LineParser parser =
                new LineParser(line, robotWords(), procedures(), blockTypes == null ? promptTypes : blockTypes);
        if (parser.isBlank()) {
            return new Accepted(List.of(), line);
        }
        return parser.isBlockLine() ? acceptBlockLine(line) : acceptCommand(parser.line(), line);
    }

    /** The words that stand for robots, with the names given by lines that may still wait for their turn. */
    private Collection<String> robotWords() {
        Collection<String> words = sessionWords.get();
        words.addAll(givenNames);
        return words;
    }

    /** What is known of the names that the next line may use. */
    private Scope<Operand> names() {
        return blockTypes == null ? promptNames : blockTypes.scope();
    }

    /** The procedures that the next line may call: also the one that it belongs to. */
    private Procedures procedures() {
        return blockProcedures == null ? procedures : blockProcedures;
    }

    private Accepted acceptCommand(Statement statement, String line) {
        PreparedLine prepared = dispatcher.prepare(statement, line, names());
        if (statement instanceof Statement.ForRobots named
                && named.command() instanceof TeamCommands.Name command
                && command.name() != null) {
            givenNames.add(command.name().text());
        }
        checkOrigin(prepared);
        if (block != null && !isUrgent(line)) {
            block.add(line);
            return new Accepted(List.of(), line);
        }
        if (block != null) {
            endBlock();
        }
        return new Accepted(List.of(prepared), line);
    }

    private void checkOrigin(PreparedLine prepared) {
        boolean isProgram = source == LineSource.SOCKET || source == LineSource.NETWORK;
        if (isProgram && prepared.has(CommandTrait.LOCAL_ONLY)) {
            throw new BotException("trust: not over a socket; type it in the window or at the terminal of MAJIC");
        }
        if (source == LineSource.NETWORK && prepared.has(CommandTrait.WRITES_FILE)) {
            throw new BotException("save: not from another computer; type it at MAJIC's own");
        }
    }

    /**
     * Alone on a line, but for a pipe's, these two cannot wait for the end of a block; "all stop" is for use in one.
     */
    private boolean isUrgent(String line) {
        String word = line.strip();
        return source != LineSource.PIPE && (word.equalsIgnoreCase("stop") || word.equalsIgnoreCase("quit"));
    }

    private Accepted acceptBlockLine(String line) {
        Types types = blockTypes == null ? new Types(null, promptNames.copy()) : blockTypes;
        Optional<Statement> head = ScriptParser.blockLine(line, types);
        head.ifPresent(statement -> dispatcher.checkHead(statement, types.scope()));
        TypedBlock open = block == null ? new TypedBlock() : block;
        open.add(line, head);
        if (!open.isOpen()) {
            endBlock();
            return acceptBlock(open.text());
        }
        block = open;
        blockTypes = types;
        enter(head, types);
        return new Accepted(List.of(), line);
    }

    /** Names that are new in a block end with it, or with an {@code else}. */
    private void enter(Optional<Statement> head, Types types) {
        if (head.isEmpty()) {
            types.end();
        }
        types.begin();
        if (head.isPresent() && head.get() instanceof Statement.ProcedureDefinition definition) {
            definition.procedure().arguments().forEach(argument -> types.argument(argument, Operand.ANY));
            blockProcedures = procedures.copy();
            blockProcedures.add(definition.procedure());
        }
    }

    private void endBlock() {
        block = null;
        blockTypes = null;
        blockProcedures = null;
    }

    private Accepted acceptBlock(String text) {
        List<Mistake> mistakes = new ArrayList<>();
        Procedures known = procedures.copy();
        List<Statement> script =
                ScriptParser.parse(text, robotWords(), known, new Types(null, promptNames.copy()), mistakes);
        if (!mistakes.isEmpty()) {
            throw new BotException(mistakes.get(0).message());
        }
        List<PreparedLine> lines = script.stream()
                .map(statement -> dispatcher.prepare(statement, text, promptNames))
                .toList();
        procedures.addAll(known);
        return new Accepted(lines, text);
    }

    /** Ends the open block, if there is one; returns its lines. */
    synchronized String dropBlock() {
        TypedBlock dropped = block;
        endBlock();
        return dropped == null ? "" : dropped.text();
    }

    synchronized boolean isBlockOpen() {
        return block != null;
    }

    /** Returns the names that the next line may use; those of an open block among them. */
    synchronized VisibleNames names(Scope<Value> values) {
        return new PromptNames(names().copy(), values, procedures().copy());
    }

    /** Parses a line; empty for a blank one and for one that belongs to a block. */
    synchronized Optional<Statement> parse(String line) {
        Types types = new Types(null, names().copy());
        LineParser parser = new LineParser(line, robotWords(), procedures(), types);
        if (parser.isBlockLine()) {
            ScriptParser.blockLine(line, types);
            return Optional.empty();
        }
        return parser.isBlank() ? Optional.empty() : Optional.of(parser.line());
    }
}

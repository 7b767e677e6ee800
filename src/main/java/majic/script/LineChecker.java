package majic.script;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.script.commands.LineParser;
import majic.script.commands.ScriptParser;
import majic.script.commands.TeamCommands;
import majic.script.lines.Dispatcher;
import majic.script.lines.LineSource;
import majic.script.lines.PreparedLine;
import majic.script.run.CommandTrait;
import majic.script.run.Statement;
import majic.script.syntax.Mistake;
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
    private @Nullable TypedBlock block;

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
        LineParser parser = new LineParser(line, robotWords());
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

    private Accepted acceptCommand(Statement statement, String line) {
        PreparedLine prepared = dispatcher.prepare(statement, line);
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
        block = null;
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
        Optional<Statement> head = ScriptParser.blockLine(line);
        head.ifPresent(dispatcher::checkHead);
        TypedBlock open = block == null ? new TypedBlock() : block;
        open.add(line, head);
        block = open.isOpen() ? open : null;
        return block == null ? acceptBlock(open.text()) : new Accepted(List.of(), line);
    }

    private Accepted acceptBlock(String text) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = ScriptParser.parse(text, robotWords(), mistakes);
        if (!mistakes.isEmpty()) {
            throw new BotException(mistakes.get(0).message());
        }
        return new Accepted(
                script.stream()
                        .map(statement -> dispatcher.prepare(statement, text))
                        .toList(),
                text);
    }

    /** Ends the open block, if there is one; returns its lines. */
    synchronized String dropBlock() {
        TypedBlock dropped = block;
        block = null;
        return dropped == null ? "" : dropped.text();
    }

    synchronized boolean isBlockOpen() {
        return block != null;
    }

    /** Parses a line; empty for a blank one and for one that belongs to a block. */
    Optional<Statement> parse(String line) {
        LineParser parser = new LineParser(line, robotWords());
        if (parser.isBlockLine()) {
            ScriptParser.blockLine(line);
            return Optional.empty();
        }
        return parser.isBlank() ? Optional.empty() : Optional.of(parser.line());
    }
}

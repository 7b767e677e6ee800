package majic.script;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.log.Line;
import majic.log.SessionOutput;
import majic.script.help.Completions;
import majic.script.help.VariableCompletion;
import majic.script.help.VisibleNames;
import majic.script.lines.DefaultRobots;
import majic.script.lines.Dispatcher;
import majic.script.lines.LineSource;
import majic.script.run.InternalError;
import majic.script.syntax.ScriptException;
import majic.text.VisibleText;

/**
 * Parses lines of MAJIC Script, checks them and submits them to the robots they are for. Each place where lines come
 * from has its own. Thread-safe.
 */
public final class MajicParser {
    private static final Pattern STOP = Pattern.compile("(?iu)\\bstop\\b");
    private static final Pattern READING = Pattern.compile("(?iu)\\b(acts?|trust|run|save)\\b");
    private static final int MOST_REMEMBERED = 10_000;

    private final Session session;
    private final SessionOutput output;
    private final Dispatcher dispatcher;
    private final LineChecker checker;
    private final DefaultRobots defaultRobots;
    private final Deque<String> commands = new ArrayDeque<>();
    private int total;

    private MajicParser(Session session, LineSource source) {
        this.session = session;
        this.output = session.output();
        this.dispatcher = new Dispatcher(session.state(), source, this);
        this.checker = new LineChecker(session::robotWords, source, dispatcher);
        this.defaultRobots = new DefaultRobots(session.team());
    }

    /**
     * Creates a parser for the lines of a user, at a prompt or in a window: a {@code get} reads at once, and a
     * {@code wait} never holds a {@code stop}.
     *
     * @param session what the lines act on, and where answers go
     * @return a new parser
     */
    public static MajicParser prompt(Session session) {
        return new MajicParser(session, LineSource.PROMPT);
    }

    /**
     * Creates a parser for the lines of a pipe, a file or a program that embeds MAJIC: every line takes its turn.
     *
     * @param session what the lines act on, and where answers go
     * @return a new parser
     */
    public static MajicParser pipe(Session session) {
        return new MajicParser(session, LineSource.PIPE);
    }

    /**
     * Creates a parser for a program on this computer at the other end of a socket: every line takes its turn as in a
     * pipe, but a {@code stop} is done at once.
     *
     * @param session what the lines act on, and where answers go
     * @return a new parser
     */
    public static MajicParser socket(Session session) {
        return new MajicParser(session, LineSource.SOCKET);
    }

    /**
     * Creates a parser for a program on another computer: as {@link #socket}, but lines that write files are refused.
     *
     * @param session what the lines act on, and where answers go
     * @return a new parser
     */
    public static MajicParser network(Session session) {
        return new MajicParser(session, LineSource.NETWORK);
    }

    /**
     * Sets the robots that a command is for if its line names none, as in {@code move 500}. Their numbers are put in
     * front of the line before anything else happens, so that listeners and a saved session have them. Without this
     * call, and while there are none, such a line is refused.
     *
     * @param robots returns their numbers, perhaps none; called on any thread that submits lines
     */
    public void useDefaultRobots(Supplier<List<Integer>> robots) {
        defaultRobots.use(robots);
    }

    /**
     * Parses one line, checks it, and submits its commands or queues it behind a {@code wait}. Returns at once. Lines
     * of an open block are kept until its {@code end}. The session's listeners receive the line, then its answers; they
     * receive a refusal as well, so the caller need not show it again. A line with the word {@code stop} that cannot be
     * understood is taken as STOP. Reads no file and waits for no robot: what a line with {@code act}, {@code trust} or
     * {@code run} names is read on a thread of this parser, and the lines behind it wait for that; a {@code stop} does
     * not.
     *
     * @param text the line; if there are several, all up to the first wrong one are accepted
     * @return empty if it was accepted; otherwise what is wrong, where, and what would be right, in one sentence; what
     *     is wrong with a file goes to the listeners only
     */
    public Optional<String> parseText(String text) {
        return parse(text, "", refusal -> {}).map(Refusal::message);
    }

    /**
     * Takes one line as {@link #parseText(String)} does; a refusal has the place of the wrong word.
     *
     * @param text the line
     * @param refusedLater receives the refusal if the line was accepted, but a file that it names does not let it be
     *     done; called on another thread
     * @return empty if it was accepted
     */
    public Optional<Refusal> submit(String text, Consumer<Refusal> refusedLater) {
        return parse(text, "", refusedLater);
    }

    /**
     * Takes one line of a file or pipe, as {@link #parseText} does; a refusal names its number.
     *
     * @param number of the line in its file or pipe, from 1
     * @param text the line
     * @return empty if it was accepted; otherwise what is wrong, where, and what would be right, in one sentence
     */
    public Optional<String> parseLine(int number, String text) {
        return parse(text, "line " + number + ": ", refusal -> {}).map(Refusal::message);
    }

    private Optional<Refusal> parse(String text, String place, Consumer<Refusal> refusedLater) {
        for (String line : text.split("\\R")) {
            Optional<Refusal> wrong = line.isBlank() ? Optional.empty() : parseWithRobots(line, place, refusedLater);
            if (wrong.isPresent()) {
                return wrong;
            }
        }
        return Optional.empty();
    }

    /**
     * Whether completing a line means looking at files, and so may wait for a disk or a network.
     *
     * @param line the line so far
     * @return true if it may name behaviours or files
     */
    public static boolean readsFiles(String line) {
        return READING.matcher(line).find();
    }

    private Optional<Refusal> parseWithRobots(String line, String place, Consumer<Refusal> refusedLater) {
        String full = defaultRobots.addTo(line);
        int added = full.length() - line.length();
        return parseOne(full, place, refusal -> refusedLater.accept(refusal.without(added)))
                .map(refusal -> refusal.without(added));
    }

    private Optional<Refusal> parseOne(String line, String place, Consumer<Refusal> refusedLater) {
        output.send(Line.Kind.COMMAND, line, this);
        try {
            LineChecker.Accepted accepted = checker.accept(line);
            remember(line);
            Consumer<String> failed = why -> refuse(accepted.text(), place, why);
            submit(accepted, line, why -> refusedLater.accept(refusal(accepted.text(), place, why)), failed);
            return Optional.empty();
        } catch (ScriptException | BotException e) {
            return Optional.of(refusal(line, place, e));
        } catch (RuntimeException | Error e) {
            return Optional.of(refusal(line, place, new BotException(InternalError.report(line, e))));
        }
    }

    private void submit(
            LineChecker.Accepted accepted, String line, Consumer<RuntimeException> refused, Consumer<String> failed) {
        Consumer<RuntimeException> forgotten = why -> {
            forget(line);
            refused.accept(why);
        };
        try {
            accepted.lines().forEach(prepared -> dispatcher.submit(prepared, forgotten, failed));
        } catch (RuntimeException | Error e) {
            forget(line);
            throw e;
        }
    }

    private Refusal refusal(String line, String place, RuntimeException reason) {
        return Refusal.of(line, refuse(line, place, String.valueOf(reason.getMessage())), reason);
    }

    private String refuse(String line, String place, String why) {
        dispatcher.commands().fail(line);
        String message = VisibleText.of(place + why);
        if (STOP.matcher(line).find()) {
            message = VisibleText.of(place + "taken as STOP: " + why);
            session.team().stopAllIfAny();
            checker.dropBlock();
        }
        output.send(Line.Kind.ERROR, message, this);
        return message;
    }

    private synchronized void remember(String line) {
        total++;
        commands.add(line);
        if (commands.size() > MOST_REMEMBERED) {
            commands.remove();
        }
    }

    private synchronized void forget(String line) {
        if (commands.removeLastOccurrence(line)) {
            total--;
        }
    }

    /**
     * The lines that were accepted, as they were typed: the thesis's {@code cmdList}.
     *
     * @return a snapshot, oldest first; of very many lines only the last ten thousand
     */
    public synchronized List<String> commands() {
        return List.copyOf(commands);
    }

    /**
     * How many lines were accepted: the thesis's {@code totalCmds}.
     *
     * @return the count
     */
    public synchronized int totalCommands() {
        return total;
    }

    /**
     * Whether a block waits for its {@code end}.
     *
     * @return true after a line such as {@code repeat 4}
     */
    public boolean isBlockOpen() {
        return checker.isBlockOpen();
    }

    /**
     * Waits until few lines wait for their turn. Call it before each line of a long pipe, so that the pipe waits and
     * not the memory fills.
     *
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    public void awaitRoom() throws InterruptedException {
        dispatcher.awaitRoom();
    }

    /**
     * At the end of a pipe: waits until all lines and all they began have ended and the listeners have received the
     * answers.
     *
     * @return as {@link #allSucceeded()}
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    public boolean awaitAll() throws InterruptedException {
        finish();
        dispatcher.awaitAll();
        output.flush();
        return allSucceeded();
    }

    /** At the end of the lines: refuses a block whose {@code end} is missing. Returns at once. */
    public void finish() {
        if (isBlockOpen()) {
            refuse(checker.dropBlock(), "", "the \"end\" of the last block is missing; nothing of it was run");
        }
    }

    /**
     * Whether few lines wait for their turn.
     *
     * @return as soon as {@link #awaitRoom()} would return
     */
    public boolean hasRoom() {
        return dispatcher.hasRoom();
    }

    /**
     * Whether all lines and all they began have ended.
     *
     * @return as soon as {@link #awaitAll()} would return, except for answers that listeners have not received yet
     */
    public boolean isDone() {
        return dispatcher.isDone();
    }

    /**
     * Whether a line can be read as MAJIC Script, whatever robots there are.
     *
     * @param line one line
     * @return false for anything else, such as the request of a web browser
     */
    public boolean isScript(String line) {
        return mistake(line).isEmpty();
    }

    /**
     * Returns why a line cannot be read as MAJIC Script, whatever robots there are. Submits nothing.
     *
     * @param line one line
     * @return a sentence; empty if the line can be read
     */
    public Optional<String> mistake(String line) {
        try {
            checker.parse(line);
            return Optional.empty();
        } catch (ScriptException e) {
            return Optional.of(String.valueOf(e.getMessage()));
        }
    }

    /**
     * Whether a line stops robots: a {@code stop}, or what {@link #parseText(String)} would take as STOP because it
     * cannot be read.
     *
     * @param line one line
     * @return true if it must not wait
     */
    public boolean isStop(String line) {
        try {
            return mentionsStop(line)
                    && checker.parse(line).filter(Dispatcher::isStop).isPresent();
        } catch (ScriptException e) {
            return true;
        }
    }

    /** Finds the word; a line without its last letter, such as one of a flood, is found out without a search. */
    private static boolean mentionsStop(String line) {
        return (line.indexOf('p') >= 0 || line.indexOf('P') >= 0)
                && STOP.matcher(line).find();
    }

    /**
     * Whether every line so far succeeded.
     *
     * @return false once a line was refused, or one of its commands failed or was stopped from elsewhere
     */
    public boolean allSucceeded() {
        return dispatcher.commands().trouble().isEmpty();
    }

    /**
     * Returns what could be typed at a place: commands, robots, parameters of the robots on the line, words that a
     * parameter takes. Reads files if {@link #readsFiles} says so.
     *
     * @param text one line
     * @param caret where the word ends that is to be completed, 0 to the length of the text
     * @return words that replace the one before the caret, and hints
     */
    public Completions complete(String text, int caret) {
        VisibleNames names = checker.names(dispatcher.names());
        return VariableCompletion.complete(names, text.substring(0, caret))
                .orElseGet(() -> completeWord(text, caret, names));
    }

    private Completions completeWord(String text, int caret, VisibleNames names) {
        String full = defaultRobots.addTo(text);
        int added = full.length() - text.length();
        Completions found = session.completer().complete(full, caret + added, defaultRobots.members(), names);
        return new Completions(Math.max(0, found.start() - added), found.entries());
    }
}

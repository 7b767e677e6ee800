package majic.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Takes lines of MAJIC Script, checks them and hands them to the robots they are for. Each place where lines come from
 * has its own. Thread-safe.
 */
public final class MajicParser {
    private final Session session;
    private final boolean interactive;
    private final List<String> commands = new ArrayList<>();

    /**
     * A parser with nothing to do yet.
     *
     * @param session what the lines act on, and where answers are told
     * @param interactive true for a person at a prompt or window, who reads a {@code get} at once and whose
     *     {@code wait} never holds a {@code stop}; false for a pipe, where every line takes its turn
     */
    public MajicParser(Session session, boolean interactive) {
        this.session = session;
        this.interactive = interactive;
    }

    /**
     * Takes one line, checks it, and gives the orders in it or queues it behind a {@code wait}. Returns at once. Lines
     * of an open block are kept until its {@code end}. The session's listeners hear the line, then what becomes of it;
     * they hear of a refusal as well, so whoever calls need not show it again.
     *
     * @param text the line
     * @return empty if it was accepted; otherwise what is wrong, where, and what would be right, in one sentence
     */
    public Optional<String> parseText(String text) {
        session.say(Line.Kind.COMMAND, text);
        synchronized (commands) {
            commands.add(text);
        }
        return Optional.empty();
    }

    /**
     * The lines that were accepted, as they were given: the thesis's {@code cmdList}.
     *
     * @return a snapshot, oldest first
     */
    public List<String> commands() {
        synchronized (commands) {
            return List.copyOf(commands);
        }
    }

    /**
     * How many lines were accepted: the thesis's {@code totalCmds}.
     *
     * @return the count
     */
    public int totalCommands() {
        return commands().size();
    }

    /**
     * Whether a block waits for its {@code end}.
     *
     * @return true after a line such as {@code repeat 4}
     */
    public boolean isBlockOpen() {
        return false;
    }

    /**
     * At the end of a pipe: waits until all lines and all they began have ended.
     *
     * @return as {@link #allSucceeded()}
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    public boolean awaitAll() throws InterruptedException {
        return allSucceeded();
    }

    /**
     * Whether every line so far did what it was told.
     *
     * @return false once a line was refused, or something it ordered failed or was stopped
     */
    public boolean allSucceeded() {
        return true;
    }

    /**
     * What could be typed at a place: commands, robots, parameters of the robots on the line, words a parameter takes.
     *
     * @param text the line so far
     * @param caret where the word ends that is to be completed, 0 to the length of the text
     * @return whole words, sorted, each to replace the one before the caret
     */
    public List<String> complete(String text, int caret) {
        return List.of();
    }
}

package majic.script;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import majic.script.run.Statement;
import majic.script.syntax.Scanner;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Token;

/** A block that is being typed line by line, with the blocks in it. Used by one thread at a time. */
public final class TypedBlock {
    private final List<String> lines = new ArrayList<>();
    private final Deque<Boolean> mayHaveElse = new ArrayDeque<>();

    /** Whether the block waits for its {@code end}. */
    public boolean isOpen() {
        return !mayHaveElse.isEmpty();
    }

    /** Adds a line with a command. */
    public void add(String line) {
        lines.add(line);
    }

    /**
     * Adds a line that begins a block, continues it with {@code else}, or ends it.
     *
     * @param head the head of a block; empty for {@code else} and {@code end}
     * @throws ScriptException if an {@code else} or {@code end} does not belong here; nothing was added
     */
    public void add(String line, Optional<Statement> head) {
        Token word = Scanner.scan(line).get(0);
        if (head.isPresent()) {
            mayHaveElse.push(head.get() instanceof Statement.If);
        } else if (word.is("else")) {
            otherwise(word);
        } else {
            close(word);
        }
        lines.add(line);
    }

    private void otherwise(Token at) {
        if (!Boolean.TRUE.equals(mayHaveElse.peek())) {
            throw new ScriptException(at, "else: there is no if in front of it");
        }
        mayHaveElse.pop();
        mayHaveElse.push(false);
    }

    private void close(Token at) {
        if (mayHaveElse.isEmpty()) {
            throw new ScriptException(at, "end: no block is open here");
        }
        mayHaveElse.pop();
    }

    /** All lines of the block, also if it is still open. */
    public String text() {
        return String.join("\n", lines);
    }
}

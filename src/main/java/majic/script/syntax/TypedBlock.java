package majic.script.syntax;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** A block that is being typed line by line. Used by one thread at a time. */
public final class TypedBlock {
    private final List<String> lines = new ArrayList<>();
    private final Deque<Boolean> mayHaveElse = new ArrayDeque<>();

    public boolean isOpen() {
        return !mayHaveElse.isEmpty();
    }

    /** Takes a line in; throws a {@link ScriptException} if it does not belong there. */
    public void add(Piece piece, String text) {
        if (piece instanceof Piece.Open open) {
            mayHaveElse.push(open.head() instanceof Statement.If);
        } else if (piece instanceof Piece.Otherwise) {
            otherwise(piece.at());
        } else if (piece instanceof Piece.Close) {
            close(piece.at());
        }
        lines.add(text);
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

    /** All lines of the block; it is empty afterwards. */
    public String take() {
        String text = String.join("\n", lines);
        lines.clear();
        mayHaveElse.clear();
        return text;
    }
}

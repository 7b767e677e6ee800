package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Reads program text command by command, counts its lines, and reports syntax errors (URBI sheet, section 11). */
public final class CommandReader {
    private final Splitter splitter = new Splitter();
    private final Consumer<String> errors;
    private Place place;
    private @Nullable String text;

    /**
     * @param start where the text begins in the count of lines
     * @param errors takes the body of each error line
     */
    public CommandReader(Place start, Consumer<String> errors) {
        this.place = start;
        this.errors = errors;
    }

    /** All commands of a whole text, in order; a last one needs no separator. */
    public static List<SeparatedStatement> all(byte[] text, Consumer<String> errors) {
        CommandReader reader = new CommandReader(new Place(1, 1), errors);
        reader.feed(text);
        reader.feed(new byte[] {'\n', ';'});
        List<SeparatedStatement> steps = new ArrayList<>();
        while (reader.isAtCommand()) {
            SeparatedStatement step = reader.take();
            if (step != null && !(step.statement() instanceof Statement.Empty)) {
                steps.add(step);
            }
        }
        return List.copyOf(steps);
    }

    public void feed(byte[] bytes) {
        splitter.feed(bytes);
    }

    /** Whether a whole command has arrived; {@link #take} gives it. */
    public boolean isAtCommand() {
        if (text == null) {
            text = splitter.next();
            if (splitter.overflowed()) {
                errors.accept("Receive buffer full");
                errors.accept("Receive buffer corrupted");
            }
        }
        return text != null;
    }

    /** The command that has arrived, or null if it has a syntax error, which has then been reported. */
    public @Nullable SeparatedStatement take() {
        String command = text == null ? "" : text;
        text = null;
        return parse(command);
    }

    /** The next bytes as they are, or null (and nothing taken) while fewer have arrived. */
    public byte @Nullable [] take(int size) {
        return splitter.take(size);
    }

    private @Nullable SeparatedStatement parse(String command) {
        Place start = place;
        List<String> invalid = new ArrayList<>();
        Lexer lexer = new Lexer(command, start, (at, problem) -> invalid.add(at + ": " + problem));
        Parser parser = new Parser(lexer.tokens());
        if (!invalid.isEmpty()) {
            place = lexer.end();
            errors.accept(invalid.get(0));
            return null;
        }
        try {
            SeparatedStatement step = parser.command();
            place = lexer.end();
            return step;
        } catch (SyntaxError error) {
            // The real kernel goes on counting behind a command only if it had understood a part of it (captures A to
            // C), or it begins with an @.
            place = error.afterCommand() ? lexer.end() : start;
            errors.accept(error.span() + ": " + error.getMessage());
            return null;
        }
    }
}

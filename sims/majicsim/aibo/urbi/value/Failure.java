package majicsim.aibo.urbi.value;

import java.util.ArrayList;
import java.util.List;

/** A run-time error with the kernel's own lines for it (URBI sheet, section 11). */
public final class Failure extends Exception {
    private static final long serialVersionUID = 1;

    private final transient List<String> lines;

    private Failure(List<String> lines) {
        // Programs that fail do so every cycle, and the place in the kernel is never shown: no stack trace is taken.
        super(String.join("; ", lines), null, false, false);
        this.lines = lines;
    }

    /**
     * An error inside an expression: the kernel adds that the evaluation failed.
     *
     * @param lines the lines before
     * @return to be thrown
     */
    public static Failure inExpression(String... lines) {
        List<String> all = new ArrayList<>(List.of(lines));
        all.add("EXPR evaluation failed");
        return new Failure(all);
    }

    /** An error that is reported as it is. */
    public static Failure of(String... lines) {
        return new Failure(List.of(lines));
    }

    /** The same error with a line before. */
    public Failure after(String line) {
        List<String> all = new ArrayList<>(List.of(line));
        all.addAll(lines);
        return new Failure(all);
    }

    public List<String> lines() {
        return lines;
    }
}

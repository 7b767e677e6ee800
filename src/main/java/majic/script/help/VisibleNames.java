package majic.script.help;

import java.util.List;
import majic.script.run.Procedures;
import majic.script.run.Scope;
import majic.script.syntax.Operand;

/** The names that a line may use at its place, and the procedures that it may call. Thread-safe. */
public interface VisibleNames {
    /** No names. */
    VisibleNames NONE = new VisibleNames() {
        @Override
        public List<Completion> values() {
            return List.of();
        }

        @Override
        public Scope<Operand> kinds() {
            return new Scope<>();
        }

        @Override
        public Procedures procedures() {
            return new Procedures();
        }
    };

    /** Returns the names with {@code $} in front, each with its value or what is known of it. */
    List<Completion> values();

    /** Returns what is known of the names, in a new scope. */
    Scope<Operand> kinds();

    /** Returns the procedures, in a new collection. */
    Procedures procedures();
}

package majicsim.aibo.urbi.syntax;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** A flag of a tagged command, such as {@code end}, with its arguments in brackets. */
public record Flag(String name, @Nullable Expr argument) {
    /** Flags that the language had before 1.0 and that became commands. */
    private static final Map<String, String> SUCCESSORS =
            Map.of("timeout", "timeout(time)", "stop", "stopif(test)", "freeze", "freezeif(test)");

    public static boolean in(List<Flag> flags, String name) {
        for (Flag flag : flags) {
            if (flag.name().equals(name)) {
                return true;
            }
        }
        return false;
    }

    /** The command that replaces this flag of an older version, or null for a present flag. */
    @Nullable
    String successor() {
        String form = SUCCESSORS.get(name);
        return form == null ? null : form.substring(0, form.indexOf('('));
    }

    /** The kernel's advice for a flag of an older version, or null for a present flag. */
    public @Nullable String warning() {
        String successor = SUCCESSORS.get(name);
        return successor == null
                ? null
                : "Warning: +" + name + " flag is obsolete. Use " + successor + " command instead.";
    }
}

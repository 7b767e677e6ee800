package majicsim.aibo.urbi.syntax;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** A flag of a tagged command, such as {@code end}, with what stands in brackets behind it. */
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

    /** The command in front of which this flag of an older version stands now, or null for a flag of today. */
    @Nullable
    String successor() {
        String form = SUCCESSORS.get(name);
        return form == null ? null : form.substring(0, form.indexOf('('));
    }

    /** What the kernel advises to use in place of a flag, or null for a flag of today. */
    public @Nullable String warning() {
        String successor = SUCCESSORS.get(name);
        return successor == null
                ? null
                : "Warning: +" + name + " flag is obsolete. Use " + successor + " command instead.";
    }
}

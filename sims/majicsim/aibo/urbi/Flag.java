package majicsim.aibo.urbi;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** A flag of a tagged command, such as {@code end}, with what stands in brackets behind it. */
record Flag(String name, @Nullable Expr argument) {
    /** Flags that the language had before 1.0 and that became commands. */
    private static final Set<String> OBSOLETE = Set.of("timeout", "stop", "freeze");

    static boolean in(List<Flag> flags, String name) {
        for (Flag flag : flags) {
            if (flag.name().equals(name)) {
                return true;
            }
        }
        return false;
    }

    boolean isObsolete() {
        return OBSOLETE.contains(name);
    }
}

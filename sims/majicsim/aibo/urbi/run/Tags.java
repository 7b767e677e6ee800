package majicsim.aibo.urbi.run;

import java.util.HashSet;
import java.util.Set;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;

/** The tags that are blocked or frozen, whether commands carry them or not (URBI sheet, section 7). */
public final class Tags {
    private final Set<String> blocked = new HashSet<>();
    private final Set<String> frozen = new HashSet<>();

    boolean isBlocked(String tag) {
        return holds(blocked, tag);
    }

    boolean isFrozen(String tag) {
        return holds(frozen, tag);
    }

    public void block(String tag) throws Failure {
        MemoryLimits.checkNames(blocked.size());
        blocked.add(tag);
    }

    public void unblock(String tag) {
        blocked.remove(tag);
    }

    public void freeze(String tag) throws Failure {
        MemoryLimits.checkNames(frozen.size());
        frozen.add(tag);
    }

    public void unfreeze(String tag) {
        frozen.remove(tag);
    }

    public void clear() {
        blocked.clear();
        frozen.clear();
    }

    /** Whether a tag is the wanted one or a part of it, as walk.left is of walk. */
    public static boolean matches(String tag, String wanted) {
        return tag.equals(wanted) || tag.startsWith(wanted + ".");
    }

    private static boolean holds(Set<String> set, String tag) {
        return set.stream().anyMatch(wanted -> matches(tag, wanted));
    }
}

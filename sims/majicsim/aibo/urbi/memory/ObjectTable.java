package majicsim.aibo.urbi.memory;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;

/**
 * The classes and objects of programs, which are the same to the kernel: each may inherit from others (URBI sheet,
 * section 10).
 */
public final class ObjectTable {
    private static final String SELF = "self.";
    private static final String LOCAL = "local.";

    private final Map<String, Set<String>> parents = new LinkedHashMap<>();

    public void define(String name) {
        parents.computeIfAbsent(name, any -> new LinkedHashSet<>());
    }

    public boolean contains(String name) {
        return parents.containsKey(name);
    }

    public int count() {
        return parents.size();
    }

    public void remove(String name) {
        parents.remove(name);
    }

    void clear() {
        parents.clear();
    }

    /** Makes an object inherit from another, which must exist; creates the object if necessary. */
    public void inherit(String name, String parent) throws Failure {
        if (!contains(parent)) {
            throw Failure.of("Unkown object " + parent);
        }
        MemoryLimits.checkNames(count());
        define(name);
        if (lineage(parent).contains(name)
                || !parents.getOrDefault(name, Set.of()).add(parent)) {
            throw Failure.of(name + " has already inherited from " + parent);
        }
    }

    /** The names under which object.field is searched, its own first; only its own for other names. */
    public List<String> places(String name) {
        int dot = name.indexOf('.');
        if (dot < 0 || !contains(name.substring(0, dot))) {
            return List.of(name);
        }
        return lineage(name.substring(0, dot)).stream()
                .map(each -> each + name.substring(dot))
                .toList();
    }

    /**
     * A name as written, with {@code local} replaced by the connection's name and {@code self} by that of the running
     * object.
     */
    public static String resolve(Scope scope, String name) {
        if (name.startsWith(LOCAL)) {
            return scope.connectionId() + name.substring(LOCAL.length() - 1);
        }
        Frame frame = scope.frame();
        boolean own = frame != null && !frame.self().isEmpty() && name.startsWith(SELF);
        return own && frame != null ? frame.self() + name.substring(SELF.length() - 1) : name;
    }

    private List<String> lineage(String name) {
        List<String> all = new ArrayList<>(List.of(name));
        for (int i = 0; i < all.size(); i++) {
            for (String parent : parents.getOrDefault(all.get(i), Set.of())) {
                if (!all.contains(parent)) {
                    all.add(parent);
                }
            }
        }
        return all;
    }
}

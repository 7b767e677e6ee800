package majicsim.aibo.urbi.memory;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The groups of variables: an assignment to a group goes to all its members (URBI sheet, section 10). */
public final class Groups {
    private final Map<String, Set<String>> members = new LinkedHashMap<>();

    /**
     * Makes a group, in place of one of the same name.
     *
     * @param group its name
     * @param names variables without their field, and other groups
     */
    public void define(String group, List<String> names) {
        members.put(group, new LinkedHashSet<>(names));
    }

    public void add(String group, List<String> names) {
        members.computeIfAbsent(group, any -> new LinkedHashSet<>()).addAll(names);
    }

    public void remove(String group, List<String> names) {
        members.getOrDefault(group, new LinkedHashSet<>()).removeAll(names);
    }

    boolean contains(String group) {
        return members.containsKey(group);
    }

    public Set<String> names() {
        return members.keySet();
    }

    /** The members as they were named. */
    public Set<String> members(String group) {
        return members.getOrDefault(group, Set.of());
    }

    Map<String, Set<String>> copy() {
        Map<String, Set<String>> copy = new LinkedHashMap<>();
        members.forEach((group, names) -> copy.put(group, new LinkedHashSet<>(names)));
        return copy;
    }

    void restore(Map<String, Set<String>> copy) {
        members.clear();
        copy.forEach((group, names) -> members.put(group, new LinkedHashSet<>(names)));
    }

    /**
     * The members that are no groups themselves; a group inside is replaced by its own members.
     *
     * @param group its name
     * @return in order, each once; none if there is no such group
     */
    public List<String> leaves(String group) {
        Set<String> leaves = new LinkedHashSet<>();
        collect(group, leaves, new ArrayList<>());
        return List.copyOf(leaves);
    }

    private void collect(String group, Set<String> leaves, List<String> visited) {
        visited.add(group);
        for (String member : members.getOrDefault(group, Set.of())) {
            if (!members.containsKey(member)) {
                leaves.add(member);
            } else if (!visited.contains(member)) {
                collect(member, leaves, visited);
            }
        }
    }
}

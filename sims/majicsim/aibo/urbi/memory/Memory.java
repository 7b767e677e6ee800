package majicsim.aibo.urbi.memory;

import java.util.Map;
import java.util.Set;

/** Everything that programs give names to, except functions: variables, groups, objects and events. */
public final class Memory {
    private final Groups groups = new Groups();
    private final ObjectTable objects = new ObjectTable();
    private final Variables variables = new Variables(groups, objects);
    private final Events events;
    private Map<String, Set<String>> systemGroups = Map.of();

    /** @param cycleMs the length of a cycle of the server */
    public Memory(double cycleMs) {
        events = new Events(cycleMs);
    }

    /**
     * The groups of variables.
     *
     * @return the same object at every call
     */
    public Groups groups() {
        return groups;
    }

    public ObjectTable objects() {
        return objects;
    }

    /**
     * The variables, to which the hardware adds its own before {@link #seal}.
     *
     * @return the same object at every call
     */
    public Variables variables() {
        return variables;
    }

    public Events events() {
        return events;
    }

    /** Marks everything that exists now as part of the system, which {@link #forget} keeps. */
    public void seal() {
        variables.seal();
        systemGroups = groups.copy();
    }

    /** Removes everything that is not part of the system. */
    public void forget() {
        variables.forget();
        groups.restore(systemGroups);
        objects.clear();
        events.removeAllOf("");
    }

    /** Removes everything that belongs to one connection. */
    public void removeAllOf(String connectionId) {
        variables.removeAllOf(connectionId);
        events.removeAllOf(connectionId + ".");
    }
}

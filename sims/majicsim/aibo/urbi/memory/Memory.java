package majicsim.aibo.urbi.memory;

import java.util.Map;
import java.util.Set;

/** What programs give names to, apart from functions: variables, groups, objects and events. */
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
     * @return the same object always
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
     * @return the same object always
     */
    public Variables variables() {
        return variables;
    }

    public Events events() {
        return events;
    }

    /** Makes what is there now the system's: {@link #forget} leaves it. */
    public void seal() {
        variables.seal();
        systemGroups = groups.copy();
    }

    /** Goes back to what the system has. */
    public void forget() {
        variables.forget();
        groups.restore(systemGroups);
        objects.clear();
        events.removeAllOf("");
    }

    /** Forgets what belongs to one connection. */
    public void removeAllOf(String connectionId) {
        variables.removeAllOf(connectionId);
        events.removeAllOf(connectionId + ".");
    }
}

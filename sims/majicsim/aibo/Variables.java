package majicsim.aibo;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * All variables of the server. A name with a dot is shared; a bare name is a device (an alias of its field val), a local variable of
 * the running function, or belongs to the connection (URBI sheet, section 5).
 */
final class Variables {
    /** More variables than this are not made. */
    private static final int MAX_COUNT = 100_000;

    private final Map<String, Variable> all = new LinkedHashMap<>();
    private final Map<String, String> aliases = new HashMap<>();
    private final Groups groups;

    Variables(Groups groups) {
        this.groups = groups;
    }

    void put(Variable variable) {
        all.put(variable.name(), variable);
    }

    Collection<Variable> all() {
        return all.values();
    }

    @Nullable
    Variable find(Context context, String key) {
        Variable local = context.frame() == null ? null : context.frame().local(key);
        return local != null ? local : all.get(fullName(context, key));
    }

    String fullName(Context context, String key) {
        String alias = aliases.get(key);
        if (alias != null) {
            return alias;
        }
        if (key.indexOf('.') >= 0) {
            return key;
        }
        return all.containsKey(key + ".val")
                ? key + ".val"
                : context.connection().id() + "." + key;
    }

    /** Makes a name stand for another variable, or with null for itself again. */
    void alias(String name, @Nullable String meaning) {
        if (meaning == null) {
            aliases.remove(name);
        } else {
            aliases.put(name, meaning);
        }
    }

    /** The variable of that name, made if need be. */
    Variable obtain(Context context, String key) throws Failure {
        Variable found = find(context, key);
        if (found != null) {
            return found;
        }
        if (all.size() >= MAX_COUNT) {
            throw Failure.of("Out of memory");
        }
        Variable made = new Variable(fullName(context, key), Value.VOID);
        put(made);
        return made;
    }

    void assign(Context context, String key, Value value) {
        Variable found = find(context, key);
        if (found == null) {
            put(new Variable(fullName(context, key), value));
        } else {
            found.write(value);
        }
    }

    /** What an assignment to that name writes: the variable, or those of all members if it names a group. */
    List<Variable> targets(Context context, Name name) throws Failure {
        String key = new Evaluator(context, Map.of()).key(name);
        int dot = key.indexOf('.');
        String head = dot < 0 ? key : key.substring(0, dot);
        if (!groups.contains(head) || find(context, key) != null) {
            return List.of(obtain(context, key));
        }
        List<Variable> targets = new ArrayList<>();
        for (String leaf : groups.leaves(head)) {
            targets.add(obtain(context, dot < 0 ? leaf : leaf + key.substring(dot)));
        }
        return targets;
    }

    /** Replaces a variable by a plain one; hardware behind it is cut off (URBI sheet, section 5). */
    void replace(Variable old, Value value) {
        put(new Variable(old.name(), value));
    }

    void remove(Context context, String key) {
        all.remove(fullName(context, key));
    }

    void removeAllOf(String connectionId) {
        all.keySet().removeIf(name -> name.startsWith(connectionId + "."));
    }
}

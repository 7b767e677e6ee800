package majicsim.aibo.urbi.memory;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.MemoryLimits;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * All variables of the server. A name with a dot is shared; a bare name is a device (an alias of its field val), a local variable
 * of the running function, or belongs to the connection (URBI sheet, section 5).
 */
public final class Variables {
    /** More variables than this are not made. */
    private static final int MAX_COUNT = 100_000;

    /** All variables together hold about so many bytes at most. */
    private static final long MAX_WEIGHT = 32 << 20;

    /** What is lighter is only counted, not weighed. */
    private static final int LIGHT = 256;

    private final Map<String, Variable> all = new LinkedHashMap<>();
    private final Map<String, String> aliases = new HashMap<>();
    private final Map<String, String> secondNames = new HashMap<>();
    private final Map<String, Variable> system = new LinkedHashMap<>();
    private final Groups groups;
    private final ObjectTable objects;
    private boolean strict;
    private long weight;
    private long weighedInPass = -1;

    Variables(Groups groups, ObjectTable objects) {
        this.groups = groups;
        this.objects = objects;
    }

    /** From now on what is there is the system's: {@link #forget} leaves it. */
    void seal() {
        all.values().forEach(Variable::keep);
        system.putAll(all);
    }

    public boolean isSystem(String name) {
        return system.containsKey(name);
    }

    /** Adds a variable that {@link #forget} leaves. */
    public void putSystem(Variable variable) {
        variable.keep();
        system.put(variable.name(), variable);
        put(variable);
    }

    /** Goes back to what the system has. */
    void forget() {
        all.clear();
        system.values().forEach(Variable::restore);
        all.putAll(system);
        aliases.clear();
        strict = false;
    }

    /** With strict, an assignment makes no variable and changes no type (URBI sheet, section 9). */
    public void strict(boolean wanted) {
        strict = wanted;
    }

    public boolean isStrict() {
        return strict;
    }

    public Map<String, String> aliases() {
        return aliases;
    }

    /**
     * Adds a variable, in place of one of the same name.
     *
     * @param variable for all connections
     */
    public void put(Variable variable) {
        all.put(variable.name(), variable);
    }

    public Collection<Variable> all() {
        return all.values();
    }

    public @Nullable Variable find(Scope scope, String key) {
        Variable local = scope.frame() == null ? null : scope.frame().local(key);
        if (local != null) {
            return local;
        }
        return objects.places(fullName(scope, key)).stream()
                .map(all::get)
                .filter(Objects::nonNull)
                .findFirst()
                .orElse(null);
    }

    /**
     * Makes a second name of a device: with any field it reaches that field of the device.
     *
     * @param name the second name, without a field
     * @param device the first
     */
    public void rename(String name, String device) {
        secondNames.put(name, device);
    }

    public String fullName(Scope scope, String written) {
        String key = firstName(ObjectTable.resolve(scope, written));
        String alias = aliases.get(key);
        if (alias != null) {
            return alias;
        }
        return key.indexOf('.') >= 0 ? key : scope.connectionId() + "." + key;
    }

    private String firstName(String key) {
        int dot = key.indexOf('.');
        String device = secondNames.get(dot < 0 ? key : key.substring(0, dot));
        return device == null ? key : device + (dot < 0 ? "" : key.substring(dot));
    }

    /** The name under which a variable is made that is not there: a bare name in a function is the function's own. */
    public String wantedName(Scope scope, String written) {
        Frame frame = scope.frame();
        return frame != null && isOwn(scope, written) ? frame.scope() + "." + written : fullName(scope, written);
    }

    private boolean isOwn(Scope scope, String written) {
        return fullName(scope, written).startsWith(scope.connectionId() + ".") && written.indexOf('.') < 0;
    }

    /** Makes a local variable of the function that runs, in place of one of the same name. */
    public void declare(Scope scope, String name, Value value) throws Failure {
        Frame frame = Objects.requireNonNull(scope.frame());
        checkCount();
        Variable variable = new Variable(frame.scope() + "." + name, value);
        put(variable);
        frame.add(name, variable);
    }

    /** Forgets the variables of a call that has ended. */
    public void drop(Frame frame) {
        frame.locals().forEach(variable -> all.remove(variable.name()));
    }

    private void checkCount() throws Failure {
        if (all.size() >= MAX_COUNT) {
            throw Failure.of(MemoryLimits.OUT_OF_MEMORY);
        }
    }

    /** Makes a name stand for another variable, or with null for itself again. */
    public void alias(String name, @Nullable String meaning) {
        if (meaning == null) {
            aliases.remove(name);
        } else {
            aliases.put(name, meaning);
        }
    }

    /** The variable of that name itself and not one it inherits, made if need be. */
    private Variable obtain(Scope scope, String key, boolean make) throws Failure {
        Variable local = scope.frame() == null ? null : scope.frame().local(key);
        Variable found = local == null ? all.get(fullName(scope, key)) : local;
        if (found != null) {
            return found;
        }
        if (!make) {
            throw Failure.of("Unknown identifier: " + wantedName(scope, key));
        }
        checkCount();
        Variable made = new Variable(wantedName(scope, key), Value.VOID);
        put(made);
        if (scope.frame() != null && isOwn(scope, key)) {
            scope.frame().add(key, made);
        }
        return made;
    }

    /** Refuses a value for which there is no memory. The variables are weighed once in a pass of the kernel. */
    public void admit(Value value, long pass) throws Failure {
        if (value.weight() < LIGHT) {
            return;
        }
        if (pass != weighedInPass) {
            weighedInPass = pass;
            weight = all.values().stream()
                    .mapToLong(each -> each.target().weight())
                    .sum();
        }
        weight += value.weight();
        if (weight > MAX_WEIGHT) {
            throw Failure.of(MemoryLimits.OUT_OF_MEMORY);
        }
    }

    public void assign(Scope scope, String key, Value value) throws Failure {
        Variable found = find(scope, key);
        (found == null ? obtain(scope, key, true) : found).write(value);
    }

    /**
     * The variable that an assignment to that name writes.
     *
     * @param make whether it may be made if it is not there; else it is an error that it is not
     */
    public Variable target(Scope scope, String key, boolean make) throws Failure {
        return obtain(scope, key, make);
    }

    /** The members that a name reaches if it is a group's, with its field; null for any other name. */
    public @Nullable List<String> members(Scope scope, String key) {
        int dot = key.indexOf('.');
        String head = dot < 0 ? key : key.substring(0, dot);
        String field = dot < 0 ? "" : key.substring(dot);
        if (!groups.contains(head) || find(scope, key) != null) {
            return null;
        }
        return groups.leaves(head).stream().map(leaf -> leaf + field).toList();
    }

    /** Replaces a variable by a plain one; hardware behind it is cut off (URBI sheet, section 5). */
    public void replace(Variable old, Value value) {
        put(new Variable(old.name(), value));
    }

    /** Forgets a variable; false if there was none. */
    public boolean remove(Scope scope, String key) {
        return all.remove(fullName(scope, key)) != null;
    }

    /** The fields of an object by their names, those of itself. */
    public Map<String, Value> fields(String object) {
        Map<String, Value> fields = new LinkedHashMap<>();
        all.forEach((name, variable) -> {
            if (name.startsWith(object + ".")) {
                fields.put(name.substring(object.length() + 1), variable.read());
            }
        });
        return fields;
    }

    void removeAllOf(String connectionId) {
        all.keySet().removeIf(name -> name.startsWith(connectionId + "."));
        system.keySet().removeIf(name -> name.startsWith(connectionId + "."));
    }
}

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
 * All variables of the server. A name with a dot is shared; a bare name is a device (an alias of its field val), a
 * local variable of the running function, or belongs to the connection (URBI sheet, section 5).
 */
public final class Variables {
    /** The largest number of variables. */
    private static final int MAX_COUNT = 100_000;

    /** The largest size of all variables together, in bytes, approximately. */
    private static final long MAX_WEIGHT = 32 << 20;

    /** The size below which values are only counted, not measured. */
    private static final int LIGHT = 256;

    private final Map<String, Variable> all = new LinkedHashMap<>();
    private final Map<String, String> aliases = new HashMap<>();
    private final Map<String, String> secondNames = new HashMap<>();
    private final Map<String, Variable> system = new LinkedHashMap<>();
    private final Groups groups;
    private final ObjectTable objects;
    /** Those that move, in the order of all; null if they have to be found again. */
    private @Nullable List<Variable> moving;

    private boolean strict;
    private long weight;
    private long weighedInPass = -1;

    Variables(Groups groups, ObjectTable objects) {
        this.groups = groups;
        this.objects = objects;
    }

    /** Marks all present variables as part of the system, which {@link #forget} keeps. */
    void seal() {
        all.values().forEach(Variable::keep);
        system.putAll(all);
    }

    public boolean isSystem(String name) {
        return system.containsKey(name);
    }

    /** Adds a variable that {@link #forget} keeps. */
    public void putSystem(Variable variable) {
        variable.keep();
        system.put(variable.name(), variable);
        put(variable);
    }

    /** Removes everything that is not part of the system. */
    void forget() {
        moving = null;
        all.clear();
        system.values().forEach(Variable::restore);
        all.putAll(system);
        aliases.clear();
        strict = false;
    }

    /** In strict mode an assignment makes no variable and changes no type (URBI sheet, section 9). */
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
        Variable before = all.put(variable.name(), variable);
        if (variable.moves() || before != null && before.moves()) {
            moving = null;
        }
    }

    public Collection<Variable> all() {
        return all.values();
    }

    /** The joints, whose derivatives are measured in each cycle. */
    public List<Variable> moving() {
        List<Variable> found = moving;
        if (found == null) {
            found = all.values().stream().filter(Variable::moves).toList();
            moving = found;
        }
        return found;
    }

    public @Nullable Variable find(Scope scope, String key) {
        Variable local = scope.frame() == null ? null : scope.frame().local(key);
        if (local != null) {
            return local;
        }
        String full = fullName(scope, key);
        Variable own = all.get(full);
        return own == null ? inherited(full) : own;
    }

    private @Nullable Variable inherited(String full) {
        for (String place : objects.places(full)) {
            Variable found = all.get(place);
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    /**
     * Makes a second name of a device, valid with all fields of the device.
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

    /** The name of a new variable: a bare name in a function is local to the function. */
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

    /** Removes the variables of a call that has ended. */
    public void drop(Frame frame) {
        frame.locals().forEach(variable -> all.remove(variable.name()));
    }

    private void checkCount() throws Failure {
        if (all.size() >= MAX_COUNT) {
            throw Failure.of(MemoryLimits.OUT_OF_MEMORY);
        }
    }

    /** Makes a name an alias of another variable, or with null ends the alias. */
    public void alias(String name, @Nullable String meaning) {
        if (meaning == null) {
            aliases.remove(name);
        } else {
            aliases.put(name, meaning);
        }
    }

    /** The variable of exactly that name, not an inherited one; created if necessary. */
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

    /** Refuses a value for which there is no memory. The variables are measured once in a pass of the kernel. */
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
     * @param make whether to create a missing variable; otherwise a missing one is an error
     */
    public Variable target(Scope scope, String key, boolean make) throws Failure {
        return obtain(scope, key, make);
    }

    /** The members of the group of this name, with the name's field; null for any other name. */
    public @Nullable List<String> members(Scope scope, String key) {
        int dot = key.indexOf('.');
        String head = dot < 0 ? key : key.substring(0, dot);
        String field = dot < 0 ? "" : key.substring(dot);
        if (!groups.contains(head) || find(scope, key) != null) {
            return null;
        }
        return groups.leaves(head).stream().map(leaf -> leaf + field).toList();
    }

    /** Replaces a variable by a plain one without hardware (URBI sheet, section 5). */
    public void replace(Variable old, Value value) {
        put(new Variable(old.name(), value));
    }

    /** Removes a variable; returns false if there was none. */
    public boolean remove(Scope scope, String key) {
        moving = null;
        return all.remove(fullName(scope, key)) != null;
    }

    /** The object's own fields by their names. */
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
        moving = null;
        all.keySet().removeIf(name -> name.startsWith(connectionId + "."));
        system.keySet().removeIf(name -> name.startsWith(connectionId + "."));
    }
}

package majicsim.aibo.urbi.memory;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** One call of a function: its local variables and what it returned. */
public final class Frame {
    private final String scope;
    private final String self;
    private final Map<String, Variable> locals = new HashMap<>();
    private Value result = Value.VOID;
    private boolean returned;

    /**
     * @param scope stands before the names of its variables, as a connection's name does before those of the connection
     * @param self the object whose function is called, empty for a function of none
     */
    public Frame(String scope, String self) {
        this.scope = scope;
        this.self = self;
    }

    String scope() {
        return scope;
    }

    String self() {
        return self;
    }

    @Nullable
    Variable local(String name) {
        return locals.get(name);
    }

    void add(String name, Variable variable) {
        locals.put(name, variable);
    }

    Collection<Variable> locals() {
        return locals.values();
    }

    public void giveBack(Value value) {
        result = value;
        returned = true;
    }

    public boolean hasReturned() {
        return returned;
    }

    public Value result() {
        return result;
    }
}

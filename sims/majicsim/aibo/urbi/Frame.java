package majicsim.aibo.urbi;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** One call of a function: its local variables and what it returned. */
final class Frame {
    private final String self;
    private final Map<String, Variable> locals = new HashMap<>();
    private Value result = Value.VOID;
    private boolean returned;

    /** @param self the object whose function is called, empty for a function of none */
    Frame(String self) {
        this.self = self;
    }

    String self() {
        return self;
    }

    @Nullable
    Variable local(String name) {
        return locals.get(name);
    }

    void declare(String name, Value value) {
        locals.put(name, new Variable(name, value));
    }

    void giveBack(Value value) {
        result = value;
        returned = true;
    }

    boolean hasReturned() {
        return returned;
    }

    Value result() {
        return result;
    }
}

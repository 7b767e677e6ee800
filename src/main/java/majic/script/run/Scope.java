package majic.script.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * The names of a block with what they stand for, inside those of the blocks around it. Names ignore case. Thread-safe.
 *
 * @param <T> what a name stands for
 */
public final class Scope<T> {
    private final @Nullable Scope<T> around;
    private final Map<String, T> names = new ConcurrentHashMap<>();

    /** The outermost names. */
    public Scope() {
        this(null);
    }

    private Scope(@Nullable Scope<T> around) {
        this.around = around;
    }

    /** The names of a block in this one. */
    public Scope<T> inner() {
        return new Scope<>(this);
    }

    /** The same names, apart from these from now on. */
    public Scope<T> copy() {
        Scope<T> copy = new Scope<>();
        copy.names.putAll(all());
        return copy;
    }

    /** The names around these. */
    public Scope<T> around() {
        return around == null ? this : around;
    }

    /** The outermost names that these are in. */
    public Scope<T> outermost() {
        return around == null ? this : around.outermost();
    }

    /** What a name stands for here; null if there is no such name. */
    public @Nullable T find(String name) {
        T value = names.get(key(name));
        return value == null && around != null ? around.find(name) : value;
    }

    /** Lets a name stand for something, where the name is known; a new name becomes one of this block. */
    public void assign(String name, T value) {
        for (Scope<T> scope = this; scope != null; scope = scope.around) {
            if (scope.names.replace(key(name), value) != null) {
                return;
            }
        }
        declare(name, value);
    }

    /** Lets a name of this block stand for something, whatever it means around it. */
    public void declare(String name, T value) {
        names.put(key(name), value);
    }

    /** All that can be named here, by name in lower case, in the order of the names. */
    public Map<String, T> all() {
        Map<String, T> all = around == null ? new TreeMap<>() : around.all();
        all.putAll(names);
        return all;
    }

    /** All names here, in their order. */
    public List<String> names() {
        return new ArrayList<>(all().keySet());
    }

    private static String key(String name) {
        return name.toLowerCase(Locale.ROOT);
    }
}

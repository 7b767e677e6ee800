package majic.script.run;

import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import majic.script.syntax.Token;

/** The procedures that lines may call, by their names, which ignore case. Thread-safe. */
public final class Procedures {
    private final Map<String, Procedure> all = new ConcurrentHashMap<>();

    /** Adds a procedure, in place of one of the same name. */
    public void add(Procedure procedure) {
        all.put(key(procedure.name()), procedure);
    }

    /** Adds those of others, in place of those of the same names. */
    public void addAll(Procedures others) {
        all.putAll(others.all);
    }

    /** The same procedures, apart from these from now on. */
    public Procedures copy() {
        Procedures copy = new Procedures();
        copy.addAll(this);
        return copy;
    }

    /** The procedure that a word calls. */
    public Optional<Procedure> find(Token word) {
        return Optional.ofNullable(all.get(key(word)));
    }

    /** The procedures, in no order. */
    public Collection<Procedure> all() {
        return all.values();
    }

    /** The names, in lower case. */
    public Collection<String> names() {
        return all.keySet();
    }

    private static String key(Token name) {
        return name.text().toLowerCase(Locale.ROOT);
    }
}

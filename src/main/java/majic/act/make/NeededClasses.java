package majic.act.make;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import majic.act.file.ClassFile;
import majic.act.file.ClassNames;
import majic.act.file.InvalidActException;

/** Finds the classes that are needed to link an act and are neither in MAJIC nor in the JDK. */
final class NeededClasses {
    private final ClassPool pool;
    private final ClassLoader majic;
    private final Map<String, byte[]> code = new TreeMap<>();
    private final Map<String, ClassFile> parsed = new TreeMap<>();
    private final Deque<String> open = new ArrayDeque<>();

    private NeededClasses(ClassPool pool, ClassLoader majic) {
        this.pool = pool;
        this.majic = majic;
    }

    /**
     * Collects the classes for an act.
     *
     * @throws InvalidActException if one of them is missing
     */
    static NeededClasses of(String actClass, ClassPool pool, ClassLoader majic) throws IOException {
        NeededClasses needed = new NeededClasses(pool, majic);
        needed.open.add(actClass);
        while (!needed.open.isEmpty()) {
            needed.take(needed.open.remove());
        }
        return needed;
    }

    private void take(String name) throws IOException {
        byte[] bytes = pool.find(name);
        if (bytes == null) {
            throw new InvalidActException("has no class " + name);
        }
        code.put(name, bytes);
        ClassFile one = ClassFile.parse(bytes);
        parsed.put(name, one);
        for (String used : one.uses()) {
            look(name, used);
        }
    }

    private void look(String user, String used) throws IOException {
        if (code.containsKey(used) || open.contains(used)) {
            return;
        }
        if (used.startsWith("majicsim.")) {
            throw new InvalidActException("has the class " + user + ", which uses " + used
                    + "; that belongs to the simulated lab, and with a true robot there is none");
        }
        if (!ClassNames.isReserved(used) && pool.find(used) != null) {
            open.add(used);
        } else if (majic.getResource(ClassNames.pathOf(used)) == null) {
            throw new InvalidActException("has the class " + user + ", which uses " + used
                    + "; that is neither with it nor in MAJIC or Java");
        }
    }

    /** Returns the bytes of each class, by name. */
    Map<String, byte[]> code() {
        return code;
    }

    Map<String, ClassFile> parsed() {
        return parsed;
    }
}

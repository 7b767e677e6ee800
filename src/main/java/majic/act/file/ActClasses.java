package majic.act.file;

import java.io.IOException;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Finds the classes that belong to an act: those of its file, its superclasses, and the classes nested in them. Only
 * MAJIC's own classes are loaded for this, and no static initialiser runs.
 */
public final class ActClasses {
    private final Map<String, ClassFile> inFile;
    private final ClassLoader majic;
    private final Set<String> lineage = new HashSet<>();

    private ActClasses(Map<String, ClassFile> inFile, ClassLoader majic) {
        this.inFile = inFile;
        this.majic = majic;
    }

    /**
     * Finds the classes that belong to an act.
     *
     * @param actClass the act's class
     * @param inFile the classes of its file, by name
     * @throws InvalidActException if the class is missing or not an act
     */
    public static ActClasses of(String actClass, Map<String, ClassFile> inFile, ClassLoader majic) throws IOException {
        ActClasses classes = new ActClasses(inFile, majic);
        String name = actClass;
        while (!name.equals(ClassNames.ACT)) {
            if (!classes.lineage.add(name) || name.equals("java.lang.Object")) {
                throw new InvalidActException("has no act in it: class " + actClass + " does not extend MajicAct");
            }
            name = classes.parentOf(name);
        }
        classes.lineage.add(ClassNames.ACT);
        return classes;
    }

    private String parentOf(String name) throws InvalidActException {
        ClassFile carried = inFile.get(name);
        if (carried != null) {
            return carried.parent();
        }
        try {
            Class<?> parent = Class.forName(name, false, majic).getSuperclass();
            return parent == null ? "java.lang.Object" : parent.getName();
        } catch (ClassNotFoundException | LinkageError e) {
            throw new InvalidActException(
                    "is an act of the class " + name + ", which is neither in it nor in this MAJIC", e);
        }
    }

    /** Returns whether a class belongs to the act. */
    public boolean has(String className) {
        return inFile.containsKey(className)
                || lineage.contains(className)
                || lineage.stream().anyMatch(one -> !inFile.containsKey(one) && className.startsWith(one + "$"));
    }
}

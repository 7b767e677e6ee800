package majic.act.file;

import java.io.IOException;
import java.util.Map;

/** Checks from a class file whether a class can be an act. */
public final class Suitability {
    private Suitability() {}

    /**
     * Checks a class.
     *
     * @param act the class
     * @param known the classes beside it
     * @throws Unfit with what is wrong and what would be right, to put behind the class's name
     */
    public static void check(ClassFile act, Map<String, ClassFile> known, ClassLoader majic) throws IOException {
        if (act.java() > Runtime.version().feature()) {
            throw new Unfit("is compiled for Java " + act.java() + ", and this is Java "
                    + Runtime.version().feature() + "; compile it with --release 17");
        }
        if (!isAct(act, known, majic)) {
            throw new Unfit("is no act: it does not extend MajicAct");
        }
        if (ActNames.isReserved(act.name())) {
            throw new Unfit("is in the package " + act.packageName() + ", which belongs to MAJIC; choose another");
        }
        if (act.isAbstract()) {
            throw new Unfit("is abstract; an act has to be complete");
        }
        switch (act.nesting()) {
            case TOP, STATIC -> {}
            case INNER -> throw new Unfit("is an inner class; make it static, or give it a file of its own");
            case LOCAL -> throw new Unfit("is declared inside a method; give it a file of its own");
        }
    }

    public static boolean isAct(ClassFile one, Map<String, ClassFile> known, ClassLoader majic) {
        try {
            Family.of(one.name(), known, majic);
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}

package majic.act.make;

import java.io.IOException;
import java.util.Map;
import majic.act.file.ActClasses;
import majic.act.file.ClassFile;
import majic.act.file.ClassNames;
import majic.act.file.InvalidActException;

/** Checks from a class file whether a class can be an act. */
final class ActClassCheck {
    private ActClassCheck() {}

    /**
     * Checks a class.
     *
     * @param act the class
     * @param known the classes beside it
     * @throws InvalidActException with what is wrong and what would be right, to put behind the class's name
     */
    static void check(ClassFile act, Map<String, ClassFile> known, ClassLoader majic) throws IOException {
        if (act.java() > Runtime.version().feature()) {
            throw new InvalidActException("is compiled for Java " + act.java() + ", and this is Java "
                    + Runtime.version().feature() + "; compile it with --release 17");
        }
        if (!isAct(act, known, majic)) {
            throw new InvalidActException("is no act: it does not extend MajicAct");
        }
        if (ClassNames.isReserved(act.name())) {
            throw new InvalidActException(
                    "is in the package " + act.packageName() + ", which belongs to MAJIC; choose another");
        }
        if (act.isAbstract()) {
            throw new InvalidActException("is abstract; an act has to be complete");
        }
        switch (act.nesting()) {
            case TOP, STATIC -> {}
            case INNER ->
                throw new InvalidActException("is an inner class; make it static, or give it a file of its own");
            case LOCAL -> throw new InvalidActException("is declared inside a method; give it a file of its own");
        }
    }

    static boolean isAct(ClassFile one, Map<String, ClassFile> known, ClassLoader majic) {
        try {
            ActClasses.of(one.name(), known, majic);
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}

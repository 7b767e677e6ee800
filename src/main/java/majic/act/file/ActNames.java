package majic.act.file;

import java.util.Optional;
import java.util.regex.Pattern;
import majic.act.MajicAct;

/** Which names of classes belong to whom, and what an act is called after its class. */
public final class ActNames {
    public static final String ACT = MajicAct.class.getName();

    private static final Pattern MAJICS = Pattern.compile("(majic|majicsim)(\\..*)?");
    private static final Pattern JAVAS = Pattern.compile("(java|javax|jdk|sun|com\\.sun|netscape\\.javascript)\\..*");
    private static final String CLASS = ".class";

    private ActNames() {}

    /** Whether no file may bring a class of this name, since its package is MAJIC's or the JDK's. */
    static boolean isReserved(String className) {
        String inPackage = className.contains(".") ? className : "";
        return MAJICS.matcher(ClassFile.packageOf(className)).matches()
                || JAVAS.matcher(inPackage).matches();
    }

    /** The class that a path in a jar is for: {@code a/B.class} for {@code a.B}. */
    static Optional<String> classAt(String path) {
        return path.endsWith(CLASS)
                ? Optional.of(path.substring(0, path.length() - CLASS.length()).replace('/', '.'))
                : Optional.empty();
    }

    public static String pathOf(String className) {
        return className.replace('.', '/') + CLASS;
    }

    /** The name behind the last dot or dollar sign. */
    static String simple(String className) {
        return className.substring(Math.max(className.lastIndexOf('.'), className.lastIndexOf('$')) + 1);
    }
}

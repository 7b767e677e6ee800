package majic.act.file;

import java.util.Optional;
import java.util.regex.Pattern;
import majic.act.MajicAct;

/** Classifies class names by package, and derives an act's name from its class. */
public final class ClassNames {
    public static final String ACT = MajicAct.class.getName();

    private static final Pattern MAJICS = Pattern.compile("(majic|majicsim)(\\..*)?");
    private static final Pattern JAVAS = Pattern.compile("(java|javax|jdk|sun|com\\.sun|netscape\\.javascript)\\..*");
    private static final Pattern NAME = Pattern.compile("[^\\s\\p{C}.;\\[/]++(\\.[^\\s\\p{C}.;\\[/]++)*+");
    private static final String CLASS = ".class";

    private ClassNames() {}

    /** Returns whether a class name is reserved: its package is MAJIC's or the JDK's, so no file may contain it. */
    public static boolean isReserved(String className) {
        return MAJICS.matcher(ClassFile.packageOf(className)).matches() || isOfJava(className);
    }

    /** Returns whether a class name is in a package of the JDK. */
    static boolean isOfJava(String className) {
        return JAVAS.matcher(className).matches();
    }

    /** Returns the class name of a path in a jar: {@code a.B} for {@code a/B.class}. */
    public static Optional<String> classAt(String path) {
        return path.endsWith(CLASS)
                ? Optional.of(path.substring(0, path.length() - CLASS.length()).replace('/', '.'))
                : Optional.empty();
    }

    /** Returns the path of a class in a jar: {@code a/B.class} for {@code a.B}. */
    public static String pathOf(String className) {
        return className.replace('.', '/') + CLASS;
    }

    /** Returns whether a text could be the name of a class: without blanks, invisible characters and empty parts. */
    static boolean isName(String text) {
        return NAME.matcher(text).matches();
    }

    /** Returns the part of a name behind the last dot or dollar sign; a dollar sign at the end belongs to it. */
    static String simple(String className) {
        int dollar = className.lastIndexOf('$', className.length() - 2);
        return className.substring(Math.max(className.lastIndexOf('.'), dollar) + 1);
    }
}

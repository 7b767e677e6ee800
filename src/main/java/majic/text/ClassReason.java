package majic.text;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Puts the refusal of the Java runtime to load a class of a plug-in into words. */
public final class ClassReason {
    private static final Pattern VERSION = Pattern.compile("class file version (\\d+)");
    private static final Pattern CLASS = Pattern.compile("[\\w$./]+");

    /** The version of class files of Java 1.0, less that release. */
    private static final int FIRST_VERSION = 44;

    private ClassReason() {}

    /**
     * Words an error that no code expects. Its cause may be a plug-in that lacks a library.
     *
     * @param problem what was thrown; the caller writes it to the log of MAJIC
     * @return half a sentence
     */
    public static String ofUnexpected(Throwable problem) {
        return problem instanceof LinkageError linkage
                ? "code cannot be loaded: " + of(linkage)
                : "an error in MAJIC, see its log";
    }

    /**
     * States why a class cannot be used.
     *
     * @param problem what the runtime threw
     * @return half a sentence that begins with a lower-case letter or with the name of a class
     */
    public static String of(LinkageError problem) {
        if (problem instanceof UnsupportedClassVersionError) {
            return tooNew(problem.getMessage());
        }
        if (problem instanceof NoClassDefFoundError && problem.getMessage() != null) {
            return missing(problem.getMessage());
        }
        if (problem instanceof ExceptionInInitializerError) {
            return "the static initialiser of one of its classes failed: " + problem.getCause();
        }
        if (problem instanceof IncompatibleClassChangeError) {
            return "it was compiled with another version of MAJIC or of a library: " + problem.getMessage();
        }
        if (problem instanceof ClassFormatError) {
            return "a class in it is damaged: " + problem.getMessage();
        }
        return "a class in it cannot be loaded: " + problem.getMessage();
    }

    private static String tooNew(@Nullable String message) {
        Matcher version = VERSION.matcher(String.valueOf(message));
        String needed =
                version.find() ? "Java " + (Integer.parseInt(version.group(1)) - FIRST_VERSION) : "a newer Java";
        return "it needs " + needed + ", and this is Java " + Runtime.version().feature();
    }

    /** The runtime gives the name with slashes, or a sentence about a class whose initialiser has failed before. */
    private static String missing(String message) {
        if (!CLASS.matcher(message).matches()) {
            return "a class in it cannot be loaded: " + message;
        }
        String name = message.replace('/', '.');
        return "the class " + name + " is missing"
                + (name.startsWith("majic.")
                        ? "; it was compiled with another version of MAJIC"
                        : "; put the jar with it into the folder lib beside the plug-in's own jar");
    }
}

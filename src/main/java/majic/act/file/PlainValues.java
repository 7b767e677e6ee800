package majic.act.file;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Lists the JDK classes whose objects an act may hold. They run no other code when they are read. */
final class PlainValues {
    private static final Set<String> CLASSES = Set.of(
            "java.lang.Boolean",
            "java.lang.Byte",
            "java.lang.Character",
            "java.lang.Double",
            "java.lang.Enum",
            "java.lang.Float",
            "java.lang.Integer",
            "java.lang.Long",
            "java.lang.Number",
            "java.lang.Short",
            "java.lang.String",
            "java.time.Ser",
            "java.util.ArrayDeque",
            "java.util.ArrayList",
            "java.util.Arrays$ArrayList",
            "java.util.CollSer",
            "java.util.EnumMap",
            "java.util.EnumSet$SerializationProxy",
            "java.util.HashMap",
            "java.util.HashSet",
            "java.util.LinkedHashMap",
            "java.util.LinkedHashSet",
            "java.util.LinkedList",
            "java.util.Random",
            "java.util.TreeMap",
            "java.util.TreeSet",
            "java.util.UUID",
            "java.util.concurrent.atomic.AtomicBoolean",
            "java.util.concurrent.atomic.AtomicInteger",
            "java.util.concurrent.atomic.AtomicLong");

    private static final Pattern ARRAY = Pattern.compile("\\[+(?:[BCDFIJSZ]|L(.+);)");

    private PlainValues() {}

    /** Returns whether a class, named as in a stream, is a plain value or an array of them. */
    static boolean has(String name) {
        String element = element(name);
        return element.isEmpty()
                || CLASSES.contains(element)
                || name.startsWith("[") && element.equals("java.lang.Object");
    }

    /** Returns the class of an array's elements, or the class itself; empty for a primitive type. */
    static String element(String name) {
        Matcher array = ARRAY.matcher(name);
        if (!array.matches()) {
            return name;
        }
        return array.group(1) == null ? "" : array.group(1);
    }
}

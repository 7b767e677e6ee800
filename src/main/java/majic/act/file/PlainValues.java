package majic.act.file;

import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Defines the JDK classes whose objects an act may hold, and the limits on them. They run no other code when read. */
public final class PlainValues {
    /** The greatest nesting depth of objects. */
    static final int MAX_DEPTH = 20;

    /** The most objects, strings and classes in a stream. */
    static final int MAX_OBJECTS = 10_000;

    /** The greatest length of an array, or of the table of a collection. */
    public static final int MAX_ARRAY = 65_536;

    /** The greatest length of a stream, bytes. */
    static final int MAX_BYTES = 1 << 20;

    private static final Set<String> LEAVES = Set.of(
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
            "java.util.Random",
            "java.util.UUID",
            "java.util.concurrent.atomic.AtomicBoolean",
            "java.util.concurrent.atomic.AtomicInteger",
            "java.util.concurrent.atomic.AtomicLong");

    /** The classes that compute the hash of their elements, or delegate to it for their own hash. */
    private static final Set<String> COLLECTIONS = Set.of(
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
            "java.util.TreeMap",
            "java.util.TreeSet");

    /** The classes that replace {@code CollSer} and similar classes after reading; they cannot occur in a stream. */
    private static final Pattern SUCCESSORS = Pattern.compile(
            "java\\.util\\.(ImmutableCollections\\$\\w+|RegularEnumSet|JumboEnumSet)|java\\.time\\.\\w+");

    private static final Pattern ARRAY = Pattern.compile("\\[+(?:[BCDFIJSZ]|L(.+);)");

    private PlainValues() {}

    /** Returns whether a class, named as in a stream, is a plain value or an array of them. */
    static boolean has(String name) {
        String element = element(name);
        return element.isEmpty()
                || LEAVES.contains(element)
                || COLLECTIONS.contains(element)
                || isArray(name) && element.equals("java.lang.Object");
    }

    /** Returns whether shared objects of a class could make reading a short stream very expensive. */
    static boolean isContainer(String name) {
        return COLLECTIONS.contains(name) || isArray(name) && !element(name).isEmpty();
    }

    /**
     * Returns whether a class does not occur in the stream itself, but is created by one that does: its table or its
     * replacement.
     */
    static boolean isMadeOfOne(Class<?> type) {
        return type == Map.Entry[].class || SUCCESSORS.matcher(type.getName()).matches();
    }

    /** Returns the class of an array's elements, or the class itself; empty for a primitive type. */
    static String element(String name) {
        Matcher array = ARRAY.matcher(name);
        if (!array.matches()) {
            return name;
        }
        return array.group(1) == null ? "" : array.group(1);
    }

    private static boolean isArray(String name) {
        return name.startsWith("[");
    }
}

package majic.act.file;

import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The JDK's classes that an act may hold objects of, and how many of them. They run nothing of others when read. */
public final class PlainValues {
    /** How deep objects may lie in one another. */
    static final int MAX_DEPTH = 20;

    /** How many objects, strings and classes a stream may have. */
    static final int MAX_OBJECTS = 10_000;

    /** How long an array, or the table of a collection, may be. */
    public static final int MAX_ARRAY = 65_536;

    /** How long a stream may be. */
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

    /** Those that compute the hash of what they hold, or hand it on when asked for their own. */
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

    /** What stands in the place of a {@code CollSer} and its like once they are read; none can be in a stream. */
    private static final Pattern SUCCESSORS = Pattern.compile(
            "java\\.util\\.(ImmutableCollections\\$\\w+|RegularEnumSet|JumboEnumSet)|java\\.time\\.\\w+");

    private static final Pattern ARRAY = Pattern.compile("\\[+(?:[BCDFIJSZ]|L(.+);)");

    private PlainValues() {}

    /** Whether a class, named as in a stream, is one of them or an array of them. */
    static boolean has(String name) {
        String element = element(name);
        return element.isEmpty()
                || LEAVES.contains(element)
                || COLLECTIONS.contains(element)
                || isArray(name) && element.equals("java.lang.Object");
    }

    /** Whether objects of a class, shared, could make a stream far larger than it is. */
    static boolean isContainer(String name) {
        return COLLECTIONS.contains(name) || isArray(name) && !element(name).isEmpty();
    }

    /** Whether a class is no class of the stream, but what one of them makes of itself: its table, or its successor. */
    static boolean isMadeOfOne(Class<?> type) {
        return type == Map.Entry[].class || SUCCESSORS.matcher(type.getName()).matches();
    }

    /** The class of an array's elements, or the class itself; empty for a number or truth value. */
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

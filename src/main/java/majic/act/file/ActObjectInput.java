package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.InvalidObjectException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Reads the object of an act. It creates objects of the act's own classes and plain values of the JDK only, and no
 * collection that contains itself. For an act without code, to which the user gives no consent, it also limits the
 * data, so that reading takes a bounded time: a set that is contained in many sets is hashed again for each of them.
 */
public final class ActObjectInput extends ObjectInputStream {
    /** The greatest nesting depth: a list of lists in a field of the act. Superclasses count as well. */
    static final int MAX_DEPTH = 5;

    /** The most values, including each repeated one. */
    static final int MAX_VALUES = 1_000;

    /** The greatest length of an array, or of the table of a collection. */
    public static final int MAX_ARRAY = 65_536;

    /** The greatest length of a stream, bytes. */
    static final int MAX_BYTES = 1 << 20;

    /** The JDK classes whose objects an act may hold. They run no other code when they are read. */
    private static final Set<String> PLAIN = Set.of(
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

    private final Predicate<String> own;
    private final ClassLoader loader;
    private final Set<Object> complete = Collections.newSetFromMap(new IdentityHashMap<>());

    private ActObjectInput(ByteArrayInputStream stream, Predicate<String> own, ClassLoader loader) throws IOException {
        super(stream);
        this.own = own;
        this.loader = loader;
        enableResolveObject(true);
    }

    /**
     * Reads the only object of a stream.
     *
     * @param data the stream
     * @param own whether a class belongs to the act, by its name
     * @param loader finds the classes; if they come from the act's file, the data is not limited
     * @throws InvalidActException if the stream is damaged, or contains an object that no act may contain
     */
    public static @Nullable Object read(byte[] data, Predicate<String> own, ClassLoader loader) throws IOException {
        ByteArrayInputStream stream = new ByteArrayInputStream(data);
        try (ActObjectInput in = new ActObjectInput(stream, own, loader)) {
            if (!(loader instanceof ActClassLoader)) {
                in.limit(data.length);
            }
            Object read = in.readObject();
            if (stream.available() > 0) {
                throw new InvalidActException("has data behind its act");
            }
            return read;
        } catch (InvalidActException e) {
            throw e;
        } catch (IOException e) {
            throw new InvalidActException(reason(e, stream.available() == 0), e);
        } catch (ClassNotFoundException e) {
            throw new InvalidActException(
                    "uses the class " + e.getMessage() + ", which is neither in it nor in this MAJIC", e);
        }
    }

    private void limit(int bytes) throws IOException {
        if (bytes > MAX_BYTES) {
            throw new InvalidActException("holds more than " + MAX_BYTES + " bytes of data");
        }
        setObjectInputFilter(ActObjectInput::checkLimits);
    }

    private static String reason(IOException e, boolean atEnd) {
        if (e instanceof InvalidClassException invalid) {
            Throwable limit = invalid.getCause();
            return limit == null
                    ? "was saved with another version of the class " + invalid.classname
                    : String.valueOf(limit.getMessage());
        }
        if (e instanceof InvalidObjectException) {
            return "is damaged: " + e.getMessage();
        }
        return atEnd ? "is cut off: its data has no end" : "is damaged: its data makes no sense";
    }

    /** The message of the exception is the cause of the one that the stream throws for it. */
    private static ObjectInputFilter.Status checkLimits(ObjectInputFilter.FilterInfo next) {
        if (next.depth() > MAX_DEPTH) {
            throw new IllegalArgumentException("nests its data more than " + MAX_DEPTH + " deep");
        }
        if (next.references() > MAX_VALUES) {
            throw new IllegalArgumentException("holds more than " + MAX_VALUES + " objects");
        }
        if (next.arrayLength() > MAX_ARRAY) {
            throw new IllegalArgumentException(
                    "holds an array of " + next.arrayLength() + " elements, more than " + MAX_ARRAY);
        }
        return ObjectInputFilter.Status.ALLOWED;
    }

    @Override
    protected Class<?> resolveClass(ObjectStreamClass described) throws IOException, ClassNotFoundException {
        String name = described.getName();
        String element = element(name);
        if (!isPlain(name) && !own.test(element)) {
            throw new InvalidActException("holds a " + element + ", which no act may hold");
        }
        return Class.forName(name, false, loader);
    }

    /** Returns whether a class, named as in a stream, is a plain value or an array of them. */
    private static boolean isPlain(String name) {
        String element = element(name);
        return element.isEmpty()
                || PLAIN.contains(element)
                || name.startsWith("[") && element.equals("java.lang.Object");
    }

    /** Returns the class of an array's elements, or the class itself; empty for a primitive type. */
    private static String element(String name) {
        Matcher array = ARRAY.matcher(name);
        if (!array.matches()) {
            return name;
        }
        return array.group(1) == null ? "" : array.group(1);
    }

    @Override
    protected Class<?> resolveProxyClass(String[] interfaces) throws IOException {
        throw new InvalidActException("holds what no act may hold: a dynamic proxy");
    }

    @Override
    protected Object resolveObject(Object read) throws IOException {
        if (isContainer(read)) {
            if (contents(read).anyMatch(element -> isContainer(element) && !complete.contains(element))) {
                throw new InvalidActException("holds a collection that holds itself");
            }
            complete.add(read);
        }
        return read;
    }

    private static boolean isContainer(@Nullable Object value) {
        return value instanceof Collection || value instanceof Map || value instanceof Object[];
    }

    private static Stream<?> contents(Object container) {
        if (container instanceof Map<?, ?> map) {
            return Stream.concat(map.keySet().stream(), map.values().stream());
        }
        return container instanceof Collection<?> collection ? collection.stream() : Stream.of((Object[]) container);
    }
}

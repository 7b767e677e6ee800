package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UTFDataFormatException;
import java.lang.reflect.Modifier;
import java.util.Set;
import java.util.TreeSet;

/**
 * Holds the description of a class in its class file, read without loading it (The Java Virtual Machine Specification,
 * chapter 4).
 *
 * @param name its name with dots
 * @param parent its superclass; empty for {@code java.lang.Object} and for modules
 * @param major the major version of its format: 61 for Java 17
 * @param flags its access flags
 * @param nesting where it is declared
 * @param uses the classes needed to link it, including itself
 */
public record ClassFile(String name, String parent, int major, int flags, Nesting nesting, Set<String> uses) {
    /** States where a class is declared. */
    public enum Nesting {
        /** At top level. */
        TOP,
        /** In another class, static. */
        STATIC,
        /** In another class; each of its objects needs an object of that class. */
        INNER,
        /** In a method, with or without a name. */
        LOCAL
    }

    private static final int MAGIC = 0xCAFEBABE;
    private static final int FIRST_MAJOR_BEHIND_JAVA_0 = 44;

    /**
     * Reads a class file.
     *
     * @throws InvalidActException if it is damaged or no class file
     */
    public static ClassFile parse(byte[] bytes) throws IOException {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            if (in.readInt() != MAGIC) {
                throw new InvalidActException("is not a class file");
            }
            return parse(in);
        } catch (EOFException e) {
            throw new InvalidActException("is a class file that is cut off", e);
        } catch (UTFDataFormatException e) {
            throw new InvalidActException("is a damaged class file", e);
        }
    }

    private static ClassFile parse(DataInputStream in) throws IOException {
        in.skipNBytes(2);
        int major = in.readUnsignedShort();
        ConstantPool pool = ConstantPool.read(in);
        int flags = in.readUnsignedShort();
        String name = pool.className(in.readUnsignedShort());
        int parent = in.readUnsignedShort();
        in.skipNBytes(2L * in.readUnsignedShort());
        Set<String> uses = new TreeSet<>(pool.classes());
        uses.addAll(readMembers(in, pool));
        uses.addAll(readMembers(in, pool));
        Nesting nesting = readNesting(in, pool, name);
        return new ClassFile(name, parent == 0 ? "" : pool.className(parent), major, flags, nesting, Set.copyOf(uses));
    }

    /** Reads fields or methods and returns the classes in their descriptors. */
    private static Set<String> readMembers(DataInputStream in, ConstantPool pool) throws IOException {
        Set<String> uses = new TreeSet<>();
        for (int left = in.readUnsignedShort(); left > 0; left--) {
            in.skipNBytes(4);
            uses.addAll(ConstantPool.classesIn(pool.text(in.readUnsignedShort())));
            for (int attributes = in.readUnsignedShort(); attributes > 0; attributes--) {
                in.skipNBytes(2);
                in.skipNBytes(Integer.toUnsignedLong(in.readInt()));
            }
        }
        return uses;
    }

    private static Nesting readNesting(DataInputStream in, ConstantPool pool, String name) throws IOException {
        Nesting nesting = Nesting.TOP;
        for (int left = in.readUnsignedShort(); left > 0; left--) {
            String attribute = pool.text(in.readUnsignedShort());
            long length = Integer.toUnsignedLong(in.readInt());
            if (attribute.equals("InnerClasses")) {
                nesting = readInnerClasses(in, pool, name);
            } else {
                in.skipNBytes(length);
            }
        }
        return nesting;
    }

    private static Nesting readInnerClasses(DataInputStream in, ConstantPool pool, String name) throws IOException {
        Nesting nesting = Nesting.TOP;
        for (int left = in.readUnsignedShort(); left > 0; left--) {
            boolean itself = pool.className(in.readUnsignedShort()).equals(name);
            boolean local = in.readUnsignedShort() == 0;
            in.skipNBytes(2);
            int flags = in.readUnsignedShort();
            if (itself) {
                nesting = local ? Nesting.LOCAL : Modifier.isStatic(flags) ? Nesting.STATIC : Nesting.INNER;
            }
        }
        return nesting;
    }

    /** Returns whether objects of the class cannot be created. */
    public boolean isAbstract() {
        return Modifier.isAbstract(flags);
    }

    /** Returns the Java version the class was compiled for: 17. */
    public int java() {
        return major - FIRST_MAJOR_BEHIND_JAVA_0;
    }

    /** Returns the package of the class; empty for the unnamed package. */
    public String packageName() {
        return packageOf(name);
    }

    /** Returns the package of a class; empty for the unnamed package. */
    static String packageOf(String className) {
        return className.substring(0, Math.max(className.lastIndexOf('.'), 0));
    }
}

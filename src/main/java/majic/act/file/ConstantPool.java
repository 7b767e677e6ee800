package majic.act.file;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the constants of a class file (The Java Virtual Machine Specification, section 4.4). */
final class ConstantPool {
    private static final int UTF8 = 1;
    private static final int CLASS = 7;
    private static final int NAME_AND_TYPE = 12;
    private static final int METHOD_TYPE = 16;
    private static final Pattern CLASS_IN_DESCRIPTOR = Pattern.compile("L([^;]+);");

    private final int[] tags;
    private final int[] indexes;
    private final String[] texts;

    private ConstantPool(int size) {
        tags = new int[size];
        indexes = new int[size];
        texts = new String[size];
    }

    static ConstantPool read(DataInputStream in) throws IOException {
        ConstantPool pool = new ConstantPool(in.readUnsignedShort());
        for (int i = 1; i < pool.tags.length; i++) {
            i += pool.readConstant(i, in);
        }
        return pool;
    }

    /**
     * Reads a constant and returns the number of further entries it takes; longs and doubles take two entries in all.
     */
    private int readConstant(int i, DataInputStream in) throws IOException {
        tags[i] = in.readUnsignedByte();
        switch (tags[i]) {
            case UTF8 -> texts[i] = in.readUTF();
            case 3, 4, 9, 10, 11, 17, 18 -> in.skipNBytes(4);
            case 5, 6 -> in.skipNBytes(8);
            case CLASS, 8, METHOD_TYPE, 19, 20 -> indexes[i] = in.readUnsignedShort();
            case NAME_AND_TYPE -> {
                in.skipNBytes(2);
                indexes[i] = in.readUnsignedShort();
            }
            case 15 -> in.skipNBytes(3);
            default -> throw new InvalidActException("is a class file with an unknown constant " + tags[i]);
        }
        return tags[i] == 5 || tags[i] == 6 ? 1 : 0;
    }

    String text(int index) throws IOException {
        if (index <= 0 || index >= texts.length || tags[index] != UTF8) {
            throw new InvalidActException("is a damaged class file");
        }
        return texts[index];
    }

    /** Returns a class's name with dots. */
    String className(int index) throws IOException {
        if (index <= 0 || index >= tags.length || tags[index] != CLASS) {
            throw new InvalidActException("is a damaged class file");
        }
        return text(indexes[index]).replace('/', '.');
    }

    /** Returns every class that the constants name, with dots; for an array the class of its elements. */
    Set<String> classes() throws IOException {
        Set<String> classes = new TreeSet<>();
        for (int i = 1; i < tags.length; i++) {
            if (tags[i] == CLASS) {
                String name = text(indexes[i]);
                classes.addAll(name.startsWith("[") ? classesIn(name) : Set.of(name.replace('/', '.')));
            } else if (tags[i] == NAME_AND_TYPE || tags[i] == METHOD_TYPE) {
                classes.addAll(classesIn(text(indexes[i])));
            }
        }
        return classes;
    }

    /** Returns the classes in the descriptor of a field or method. */
    static Set<String> classesIn(String descriptor) {
        Set<String> classes = new TreeSet<>();
        Matcher found = CLASS_IN_DESCRIPTOR.matcher(descriptor);
        while (found.find()) {
            classes.add(found.group(1).replace('/', '.'));
        }
        return classes;
    }
}

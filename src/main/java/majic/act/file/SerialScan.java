package majic.act.file;

import static java.io.ObjectStreamConstants.*;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UTFDataFormatException;
import java.util.LinkedHashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Parses an object stream without creating any object of it (Java Object Serialization Specification, chapter 6), to
 * list its classes and to refuse data that is too large, too deep, shared, cyclic or not plain.
 */
public final class SerialScan {
    private final DataInputStream in;
    private final SerialHandles handles = new SerialHandles();
    private final Set<String> classes = new LinkedHashSet<>();

    private SerialScan(byte[] stream) {
        this.in = new DataInputStream(new ByteArrayInputStream(stream));
    }

    /**
     * Parses a stream of one object.
     *
     * @return the classes in it without those of plain values, the object's own first
     * @throws Unfit if the stream is not permitted for an act
     */
    public static Set<String> classes(byte[] stream) throws IOException {
        if (stream.length > PlainValues.MAX_BYTES) {
            throw new Unfit("holds more than " + PlainValues.MAX_BYTES + " bytes of data");
        }
        try {
            return new SerialScan(stream).scan();
        } catch (EOFException e) {
            throw new Unfit("is cut off: its data has no end", e);
        } catch (UTFDataFormatException e) {
            throw damaged();
        }
    }

    private Set<String> scan() throws IOException {
        if (in.readShort() != STREAM_MAGIC || in.readShort() != STREAM_VERSION) {
            throw new Unfit("holds no object stream");
        }
        if (in.readByte() != TC_OBJECT) {
            throw new Unfit("holds no act, but other data");
        }
        object(0);
        if (in.available() > 0) {
            throw new Unfit("has data behind its act");
        }
        return classes;
    }

    private void content(byte tag, int depth) throws IOException {
        if (depth > PlainValues.MAX_DEPTH) {
            throw new Unfit("nests its data more than " + PlainValues.MAX_DEPTH + " deep");
        }
        switch (tag) {
            case TC_NULL -> {}
            case TC_REFERENCE -> handles.checkValue(in.readInt());
            case TC_STRING -> text(in.readUnsignedShort());
            case TC_LONGSTRING -> text(in.readLong());
            case TC_OBJECT -> object(depth);
            case TC_ARRAY -> array(depth);
            case TC_ENUM -> constant();
            case TC_CLASS -> aboutClass(depth);
            default -> throw new Unfit("holds what no act may hold: " + nameOf(tag));
        }
    }

    private static String nameOf(byte tag) {
        return switch (tag) {
            case TC_CLASSDESC -> "a description of a class";
            case TC_PROXYCLASSDESC -> "a dynamic proxy";
            case TC_EXCEPTION -> "a broken-off stream";
            default -> "data of an unknown kind";
        };
    }

    private void text(long length) throws IOException {
        handles.add(true).close();
        if (length < 0 || length > PlainValues.MAX_BYTES) {
            throw new Unfit("holds a text that is too long");
        }
        in.skipNBytes(length);
    }

    private void object(int depth) throws IOException {
        SerialClass type = describedClass(depth);
        if (type.isEnum() || !type.isReadable()) {
            throw damaged();
        }
        SerialHandles.Node node = handles.add(!PlainValues.isContainer(type.name()));
        for (SerialClass one : type.lineage()) {
            if (one.hasFields()) {
                values(one.fieldTypes(), depth);
            }
            if (one.hasMore()) {
                more(depth);
            }
        }
        node.close();
    }

    private void values(String types, int depth) throws IOException {
        for (char type : types.toCharArray()) {
            value(type, depth);
        }
    }

    private void value(char type, int depth) throws IOException {
        switch (type) {
            case 'B', 'Z' -> in.skipNBytes(1);
            case 'C', 'S' -> in.skipNBytes(2);
            case 'F', 'I' -> in.skipNBytes(4);
            case 'D', 'J' -> in.skipNBytes(8);
            case 'L', '[' -> content(in.readByte(), depth + 1);
            default -> throw damaged();
        }
    }

    /** Reads the data that a class has written beside its fields. */
    private void more(int depth) throws IOException {
        for (byte tag = in.readByte(); tag != TC_ENDBLOCKDATA; tag = in.readByte()) {
            switch (tag) {
                case TC_BLOCKDATA -> in.skipNBytes(in.readUnsignedByte());
                case TC_BLOCKDATALONG -> in.skipNBytes(Integer.toUnsignedLong(in.readInt()));
                default -> content(tag, depth + 1);
            }
        }
    }

    private void array(int depth) throws IOException {
        SerialClass type = describedClass(depth);
        if (!type.name().startsWith("[")) {
            throw damaged();
        }
        SerialHandles.Node node = handles.add(!PlainValues.isContainer(type.name()));
        int length = in.readInt();
        if (length < 0 || length > PlainValues.MAX_ARRAY) {
            throw new Unfit("holds an array of " + Integer.toUnsignedString(length) + " elements, more than "
                    + PlainValues.MAX_ARRAY);
        }
        for (int i = 0; i < length; i++) {
            value(type.name().charAt(1), depth);
        }
        node.close();
    }

    /** Reads a class used as a value, as in tables of enums. */
    private void aboutClass(int depth) throws IOException {
        describedClass(depth);
        handles.add(true).close();
    }

    private void constant() throws IOException {
        describedClass(0);
        SerialHandles.Node node = handles.add(true);
        fieldName();
        node.close();
    }

    /** Reads a mandatory text: the type of a field or the name of an enum's constant. */
    private void fieldName() throws IOException {
        switch (in.readByte()) {
            case TC_STRING -> text(in.readUnsignedShort());
            case TC_REFERENCE -> handles.checkValue(in.readInt());
            default -> throw damaged();
        }
    }

    private SerialClass describedClass(int depth) throws IOException {
        SerialClass type = classOrNone(depth);
        if (type == null) {
            throw damaged();
        }
        return type;
    }

    private @Nullable SerialClass classOrNone(int depth) throws IOException {
        byte tag = in.readByte();
        return switch (tag) {
            case TC_NULL -> null;
            case TC_CLASSDESC -> newClass(depth);
            case TC_REFERENCE -> handles.classAt(in.readInt());
            default -> throw new Unfit("holds what no act may hold: " + nameOf(tag));
        };
    }

    private SerialClass newClass(int depth) throws IOException {
        if (depth > PlainValues.MAX_DEPTH) {
            throw damaged();
        }
        String name = in.readUTF();
        in.skipNBytes(Long.BYTES);
        SerialHandles.Node node = handles.add(false);
        if (!PlainValues.has(name)) {
            classes.add(PlainValues.element(name));
        }
        int flags = in.readUnsignedByte();
        String fields = fieldTypes();
        if (in.readByte() != TC_ENDBLOCKDATA) {
            throw new Unfit("describes the class " + name + " in a foreign way");
        }
        SerialClass described = new SerialClass(name, flags, fields, classOrNone(depth + 1));
        node.close(described);
        return described;
    }

    private String fieldTypes() throws IOException {
        StringBuilder types = new StringBuilder();
        for (int left = in.readUnsignedShort(); left > 0; left--) {
            char type = (char) in.readUnsignedByte();
            in.skipNBytes(in.readUnsignedShort());
            if (type == 'L' || type == '[') {
                fieldName();
            }
            types.append(type);
        }
        return types.toString();
    }

    static Unfit damaged() {
        return new Unfit("is damaged: its data makes no sense");
    }
}

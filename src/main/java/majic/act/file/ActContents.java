package majic.act.file;

import static java.io.ObjectStreamConstants.TC_CLASSDESC;
import static java.io.ObjectStreamConstants.TC_OBJECT;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UTFDataFormatException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Manifest;
import majic.act.ActDetails;
import majic.act.Role;

/**
 * Holds the parts of an act's file, checked, without loading any of its code.
 *
 * @param manifest the file's manifest
 * @param signers the file's signers
 * @param entries its classes and other files by path; empty if the file is only an object stream
 * @param classes its classes by name
 * @param data the object stream of the act
 * @param own the classes that belong to the act
 */
public record ActContents(
        ActManifest manifest,
        List<Signer> signers,
        Map<String, byte[]> entries,
        Map<String, ClassFile> classes,
        byte[] data,
        ActClasses own) {
    public static final String DATA = "act.ser";

    private static final int JAR = 0x504B0304;
    private static final int STREAM = 0xACED0005;

    /**
     * Reads and checks the parts of a file.
     *
     * @throws InvalidActException if it is not an act, or one that this MAJIC must not or cannot load
     */
    static ActContents of(byte[] file, ClassLoader majic) throws IOException {
        if (file.length > BoundedZip.MAX_FILE_BYTES) {
            throw new InvalidActException(
                    "is larger than " + (BoundedZip.MAX_FILE_BYTES >> 20) + " MB, which no act is");
        }
        return switch (firstFour(file)) {
            case JAR -> ofJar(file, majic);
            case STREAM -> ofStream(file, majic);
            case 0 -> throw new InvalidActException("is empty or cut off");
            default -> throw new InvalidActException("is no act: neither a jar nor a saved object");
        };
    }

    private static int firstFour(byte[] file) {
        return file.length < Integer.BYTES
                ? 0
                : file[0] << 24 | (file[1] & 0xFF) << 16 | (file[2] & 0xFF) << 8 | file[3] & 0xFF;
    }

    private static ActContents ofStream(byte[] file, ClassLoader majic) throws IOException {
        String actClass = classOf(file);
        ActManifest manifest = new ActManifest(
                actClass, ActDetails.named(ClassNames.simple(actClass)), "", List.of(Role.any(Role.ME)), List.of());
        return new ActContents(manifest, List.of(), Map.of(), Map.of(), file, ActClasses.of(actClass, Map.of(), majic));
    }

    /** Returns the name at the beginning of an object stream (Java Object Serialization Specification, chapter 6). */
    private static String classOf(byte[] stream) throws IOException {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(stream))) {
            in.skipNBytes(Integer.BYTES);
            String name = in.readByte() == TC_OBJECT && in.readByte() == TC_CLASSDESC ? in.readUTF() : "";
            if (name.isEmpty() || ClassNames.isOfJava(name)) {
                throw new InvalidActException("holds no act, but other data");
            }
            return name;
        } catch (EOFException e) {
            throw new InvalidActException("is cut off: its data has no end", e);
        } catch (UTFDataFormatException e) {
            throw new InvalidActException("is damaged: its data makes no sense", e);
        }
    }

    private static ActContents ofJar(byte[] file, ClassLoader majic) throws IOException {
        Map<String, byte[]> entries = BoundedZip.unpack(file);
        Manifest said = ActManifest.parse(entry(entries, ActManifest.PATH));
        ActManifest manifest = ActManifest.of(said);
        List<Signer> signers = Signatures.check(file, entries.keySet(), said);
        Map<String, ClassFile> classes = classes(entries);
        ActClasses own = ActClasses.of(manifest.actClass(), classes, majic);
        return new ActContents(manifest, signers, entries, classes, entry(entries, DATA), own);
    }

    private static byte[] entry(Map<String, byte[]> entries, String path) throws InvalidActException {
        byte[] entry = entries.get(path);
        if (entry == null) {
            throw new InvalidActException("is a jar, but no act: it has no " + path);
        }
        return entry;
    }

    private static Map<String, ClassFile> classes(Map<String, byte[]> entries) throws IOException {
        Map<String, ClassFile> classes = new TreeMap<>();
        for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
            String name = ClassNames.classAt(entry.getKey()).orElse("");
            if (!name.isEmpty()) {
                classes.put(name, checkedClass(name, entry.getValue()));
            }
        }
        return classes;
    }

    private static ClassFile checkedClass(String name, byte[] bytes) throws IOException {
        ClassFile code = parsedClass(name, bytes);
        if (!code.name().equals(name)) {
            throw new InvalidActException("has the class " + code.name() + " in the place of " + name);
        }
        if (ClassNames.isReserved(name)) {
            throw new InvalidActException("brings a class " + name + ", but that package belongs to MAJIC or Java");
        }
        if (code.java() > Runtime.version().feature()) {
            throw new InvalidActException("is compiled for Java " + code.java() + ", and this is Java "
                    + Runtime.version().feature() + "; compile it with --release "
                    + Runtime.version().feature());
        }
        return code;
    }

    private static ClassFile parsedClass(String name, byte[] bytes) throws IOException {
        try {
            return ClassFile.parse(bytes);
        } catch (IOException e) {
            throw new InvalidActException("is damaged: its " + name + " " + e.getMessage(), e);
        }
    }
}

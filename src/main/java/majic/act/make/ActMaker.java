package majic.act.make;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import majic.act.ActDetails;
import majic.act.ActException;
import majic.act.MajicAct;
import majic.act.file.ActClassLoader;
import majic.act.file.ActClasses;
import majic.act.file.ActContents;
import majic.act.file.ActFile;
import majic.act.file.ActManifest;
import majic.act.file.ClassFile;
import majic.act.file.ClassNames;
import majic.act.file.InvalidActException;

/**
 * Makes an act's file from compiled classes, or from one source file. The class's constructor runs once, so that its
 * object can be saved; this is the author's own code on the author's own computer.
 */
public final class ActMaker {
    /** Later than the earliest time of zip files, with which Java also stores a time that depends on the time zone. */
    private static final LocalDateTime NO_TIME = LocalDateTime.of(1980, 2, 1, 0, 0);

    private final ClassPool pool;
    private final Map<String, ClassFile> named = new TreeMap<>();

    private ActMaker(ClassPool pool) throws IOException {
        this.pool = pool;
        for (Map.Entry<String, byte[]> one : pool.named().entrySet()) {
            named.put(one.getKey(), ClassFile.parse(one.getValue()));
        }
    }

    /**
     * Opens the classes or the source of an act. A source file is compiled; none of its code runs yet.
     *
     * @param classes a class file in the folder of its package, a folder of such, a jar, or a single {@code .java}
     *     source
     * @return a maker for the acts in it
     * @throws ActException if it cannot be read or compiled
     */
    public static ActMaker from(Path classes) {
        ClassPool pool = ClassPool.of(classes);
        try {
            return new ActMaker(pool);
        } catch (IOException e) {
            throw new ActException(pool.label() + " " + e.getMessage(), e);
        }
    }

    /**
     * Returns the classes that can be acts, as far as their class files show.
     *
     * @return their names, sorted; possibly none
     */
    public List<String> acts() {
        return named.values().stream()
                .filter(this::isSuitable)
                .map(ClassFile::name)
                .toList();
    }

    private boolean isSuitable(ClassFile one) {
        try {
            ActClassCheck.check(one, named, ActFile.MAJIC);
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    /**
     * Returns the class of the only act.
     *
     * @return the name of its class
     * @throws ActException if there is none, with the reason, or more than one
     */
    public String onlyAct() {
        List<String> acts = acts();
        if (acts.size() == 1) {
            return acts.get(0);
        }
        if (acts.isEmpty()) {
            throw new ActException(pool.label() + " " + whyNone());
        }
        throw new ActException(pool.label() + " has several acts; choose one of " + String.join(", ", acts));
    }

    private String whyNone() {
        List<ClassFile> meant = named.values().stream()
                .filter(one -> ActClassCheck.isAct(one, named, ActFile.MAJIC))
                .toList();
        for (ClassFile one : meant.isEmpty() && named.size() == 1 ? List.copyOf(named.values()) : meant) {
            try {
                ActClassCheck.check(one, named, ActFile.MAJIC);
            } catch (IOException e) {
                return "has no act: " + one.name() + " " + e.getMessage();
            }
        }
        return "has no act: none of its classes extends MajicAct";
    }

    /**
     * Makes the file of an act, and reads it back as a check.
     *
     * @param actClass the act's class, one of {@link #acts()}
     * @param details name, version, author and description of the act
     * @return the whole file; the same classes and details give the same bytes
     * @throws ActException if the class is not suitable, with the reason and what would be right
     */
    public byte[] make(String actClass, ActDetails details) {
        try {
            if (!named.containsKey(actClass)) {
                throw new InvalidActException("is not in " + pool.label());
            }
            NeededClasses needed = NeededClasses.of(actClass, pool, ActFile.MAJIC);
            ActClassCheck.check(needed.parsed().get(actClass), needed.parsed(), ActFile.MAJIC);
            Map<String, byte[]> files = byPath(needed.code());
            files.putAll(pool.beside(needed.code().keySet()));
            MajicAct act = FreshAct.of(actClass, new ActClassLoader(actClass, files, ActFile.MAJIC));
            return tried(pack(act, ActClasses.of(actClass, needed.parsed(), ActFile.MAJIC), details, files));
        } catch (IOException e) {
            throw new ActException(actClass + " " + e.getMessage(), e);
        }
    }

    /**
     * Makes the file of an act of a class that MAJIC has itself, such as a script; such a file brings no code.
     *
     * @param act the act, with its data, not started
     * @param details name, version, author and description of the act
     * @return the whole file
     * @throws ActException if the act cannot be saved, or its class is not MAJIC's
     */
    public static byte[] save(MajicAct act, ActDetails details) {
        String actClass = act.getClass().getName();
        try {
            return tried(pack(act, ActClasses.of(actClass, Map.of(), ActFile.MAJIC), details, Map.of()));
        } catch (IOException e) {
            throw new ActException(actClass + " " + e.getMessage(), e);
        }
    }

    private static byte[] pack(MajicAct act, ActClasses own, ActDetails details, Map<String, byte[]> files)
            throws IOException {
        ActManifest manifest = new ActManifest(
                act.getClass().getName(), details, majicVersion(), FreshAct.roles(act), FreshAct.arguments(act));
        return zip(manifest, files, SavedAct.of(act, own));
    }

    /**
     * Packs a file. The same contents give the same bytes, so that a consent given once stays valid.
     *
     * @param manifest the file's manifest
     * @param files the classes and the files beside them, by path
     * @param data the object stream of the act
     */
    private static byte[] zip(ActManifest manifest, Map<String, byte[]> files, byte[] data) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream out = new ZipOutputStream(bytes)) {
            put(out, ActManifest.PATH, manifest.bytes());
            put(out, ActContents.DATA, data);
            for (Map.Entry<String, byte[]> one : new TreeMap<>(files).entrySet()) {
                put(out, one.getKey(), one.getValue());
            }
        } catch (IOException e) {
            throw new IllegalStateException("memory takes what is written to it", e);
        }
        return bytes.toByteArray();
    }

    private static void put(ZipOutputStream out, String path, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(path);
        entry.setTimeLocal(NO_TIME);
        out.putNextEntry(entry);
        out.write(bytes);
        out.closeEntry();
    }

    private static byte[] tried(byte[] file) {
        ActFile.of("the new file", file).loadAgreed();
        return file;
    }

    private static String majicVersion() {
        String version = MajicAct.class.getPackage().getImplementationVersion();
        return version == null ? "" : version;
    }

    private static Map<String, byte[]> byPath(Map<String, byte[]> code) {
        Map<String, byte[]> paths = new TreeMap<>();
        code.forEach((name, bytes) -> paths.put(ClassNames.pathOf(name), bytes));
        return paths;
    }
}

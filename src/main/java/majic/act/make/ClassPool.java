package majic.act.make;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.act.ActException;
import majic.act.file.ActContents;
import majic.act.file.BoundedZip;
import majic.act.file.ClassFile;
import majic.act.file.ClassNames;
import majic.act.file.InvalidActException;
import majic.text.IoReason;
import org.jspecify.annotations.Nullable;

/**
 * Holds the classes an act may be made from: those of a class file and of the files around it, of a folder, a jar or a
 * source.
 *
 * @param label the name of the input in errors
 * @param named the given classes, by name; one of them may be the act
 * @param root the folder in which further classes are searched for; null for none
 * @param others the other files in the folder or jar, which an act might read, by path
 */
record ClassPool(
        String label, Map<String, byte[]> named, @Nullable Path root, Map<String, Content> others) {
    /** Reads a file only when it is needed. */
    interface Content {
        byte[] read() throws IOException;
    }

    private static final int MAX_CLASSES = 2_000;
    private static final Pattern NOT_FOR_ACTS =
            Pattern.compile("META-INF/.*|(.*/)?\\..*|.*\\.(class|java|jar|act)|" + ActContents.DATA);

    /**
     * Opens the file or folder given by the user.
     *
     * @throws ActException if there are no classes in it
     */
    static ClassPool of(Path given) {
        String label = String.valueOf(given.getFileName());
        String kind = label.toLowerCase(Locale.ROOT);
        try {
            if (Files.isDirectory(given)) {
                return ofFolder(label, given);
            }
            if (kind.endsWith(".class")) {
                return ofClass(label, given.toAbsolutePath());
            }
            if (kind.endsWith(".java")) {
                return new ClassPool(label, JavaSource.compile(given), null, Map.of());
            }
            return ofJar(label, BoundedZip.unpack(Files.readAllBytes(given)));
        } catch (NoSuchFileException e) {
            throw new ActException("there is no file " + given, e);
        } catch (InvalidActException e) {
            throw new ActException(label + " " + e.getMessage(), e);
        } catch (IOException e) {
            throw new ActException("cannot read " + given + ": " + IoReason.of(e), e);
        }
    }

    private static ClassPool ofClass(String label, Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        String name = ClassFile.parse(bytes).name();
        Path path = Path.of(ClassNames.pathOf(name));
        if (!file.endsWith(path)) {
            throw new InvalidActException("is the class " + name + "; its place is " + path);
        }
        Path root = file;
        for (int i = 0; i < path.getNameCount() && root != null; i++) {
            root = root.getParent();
        }
        return new ClassPool(label, Map.of(name, bytes), root, Map.of());
    }

    private static ClassPool ofFolder(String label, Path folder) throws IOException {
        Map<String, byte[]> classes = new HashMap<>();
        Map<String, Content> others = new HashMap<>();
        try (Stream<Path> found = Files.walk(folder)) {
            for (Path file : found.filter(Files::isRegularFile).toList()) {
                String path = folder.relativize(file).toString().replace('\\', '/');
                if (path.endsWith(".class")) {
                    checkCount(classes.size());
                    classes.put(path, Files.readAllBytes(file));
                } else if (isForActs(path)) {
                    others.put(path, () -> readFile(file));
                }
            }
        }
        return new ClassPool(label, classesAmong(classes), null, others);
    }

    private static void checkCount(int classes) throws InvalidActException {
        if (classes == MAX_CLASSES) {
            throw new InvalidActException("has more than " + MAX_CLASSES + " classes; name the act's own class file");
        }
    }

    private static byte[] readFile(Path file) throws IOException {
        if (Files.size(file) > BoundedZip.MAX_ENTRY_BYTES) {
            throw new InvalidActException("has beside it the file " + file.getFileName() + ", which is larger than "
                    + (BoundedZip.MAX_ENTRY_BYTES >> 20) + " MB; move it elsewhere");
        }
        return Files.readAllBytes(file);
    }

    private static ClassPool ofJar(String label, Map<String, byte[]> entries) {
        Map<String, Content> others = new HashMap<>();
        entries.forEach((path, bytes) -> {
            if (isForActs(path)) {
                others.put(path, () -> bytes);
            }
        });
        return new ClassPool(label, classesAmong(entries), null, others);
    }

    private static boolean isForActs(String path) {
        return !NOT_FOR_ACTS.matcher(path).matches();
    }

    private static String folderOf(String path) {
        return path.substring(0, path.lastIndexOf('/') + 1);
    }

    private static Map<String, byte[]> classesAmong(Map<String, byte[]> files) {
        Map<String, byte[]> classes = new HashMap<>();
        files.forEach((path, bytes) -> ClassNames.classAt(path)
                .filter(name -> !path.startsWith("META-INF/") && !name.endsWith("module-info"))
                .ifPresent(name -> classes.put(name, bytes)));
        return classes;
    }

    /** Returns the files in the same folders as some classes, by path: texts or pictures that these may read. */
    Map<String, byte[]> beside(Collection<String> classes) throws IOException {
        Set<String> folders =
                classes.stream().map(name -> folderOf(ClassNames.pathOf(name))).collect(Collectors.toSet());
        Map<String, byte[]> beside = new HashMap<>();
        for (Map.Entry<String, Content> other : others.entrySet()) {
            if (folders.contains(folderOf(other.getKey()))) {
                beside.put(other.getKey(), other.getValue().read());
            }
        }
        return beside;
    }

    /** Returns the bytes of a class, or null if it is not in the pool. */
    byte @Nullable [] find(String className) throws IOException {
        byte[] known = named.get(className);
        if (known != null || root == null || ClassNames.isReserved(className)) {
            return known;
        }
        Path file = root.resolve(ClassNames.pathOf(className));
        return Files.isRegularFile(file) ? Files.readAllBytes(file) : null;
    }
}

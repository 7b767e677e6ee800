package majic.act;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The classes an act may be made of: those of a class file and what lies around it, of a folder, a jar or a source.
 *
 * @param label what to call it in errors
 * @param named the classes that were given, by name; one of them may be the act
 * @param root where further classes are looked for; null for nowhere
 */
record ClassPool(
        String label, Map<String, byte[]> named, @Nullable Path root) {
    private static final int MAX_CLASSES = 2_000;

    /**
     * Opens what the user gave.
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
                return new ClassPool(label, JavaSource.compile(given), null);
            }
            return new ClassPool(label, classesAmong(BoundedZip.unpack(Files.readAllBytes(given))), null);
        } catch (NoSuchFileException e) {
            throw new ActException("there is no file " + given, e);
        } catch (Unfit e) {
            throw new ActException(label + " " + e.getMessage(), e);
        } catch (IOException e) {
            throw new ActException("cannot read " + given + ": " + e.getMessage(), e);
        }
    }

    private static ClassPool ofClass(String label, Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        String name = ClassFile.parse(bytes).name();
        Path path = Path.of(ActNames.pathOf(name));
        if (!file.endsWith(path)) {
            throw new Unfit("is the class " + name + "; its place is " + path);
        }
        Path root = file;
        for (int i = 0; i < path.getNameCount() && root != null; i++) {
            root = root.getParent();
        }
        return new ClassPool(label, Map.of(name, bytes), root);
    }

    private static ClassPool ofFolder(String label, Path folder) throws IOException {
        Map<String, byte[]> files = new HashMap<>();
        try (Stream<Path> found = Files.walk(folder)) {
            List<Path> classes = found.filter(file -> file.toString().endsWith(".class"))
                    .limit(MAX_CLASSES + 1)
                    .toList();
            if (classes.size() > MAX_CLASSES) {
                throw new Unfit("has more than " + MAX_CLASSES + " classes; name the act's own class file");
            }
            for (Path file : classes) {
                files.put(folder.relativize(file).toString().replace('\\', '/'), Files.readAllBytes(file));
            }
        }
        return new ClassPool(label, classesAmong(files), null);
    }

    private static Map<String, byte[]> classesAmong(Map<String, byte[]> files) {
        Map<String, byte[]> classes = new HashMap<>();
        files.forEach((path, bytes) -> ActNames.classAt(path)
                .filter(name -> !path.startsWith("META-INF/") && !name.endsWith("module-info"))
                .ifPresent(name -> classes.put(name, bytes)));
        return classes;
    }

    /** The code of a class, or null if it is not here. */
    byte @Nullable [] find(String className) throws IOException {
        byte[] known = named.get(className);
        if (known != null || root == null || ActNames.isReserved(className)) {
            return known;
        }
        Path file = root.resolve(ActNames.pathOf(className));
        return Files.isRegularFile(file) ? Files.readAllBytes(file) : null;
    }
}

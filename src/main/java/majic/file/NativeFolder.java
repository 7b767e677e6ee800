package majic.file;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The folder in which libraries unpack their native code before they load it: it belongs to this user, and no other
 * user can write to it, so that no other user's code is loaded. By itself a library such as jSerialComm 2.11.4 or
 * gdx-jnigen-loader 2.2.0 loads a file that exists already under a fixed name in the temporary directory, which every
 * user may write. Thread-safe; all methods block.
 */
public final class NativeFolder {
    /** The environment variable that names another folder, in which this one is created. */
    public static final String CHOICE = "MAJIC_NATIVE";

    private static final String TEMPORARY = "java.io.tmpdir";
    private static final int WRITABLE_BY_OTHERS = 0002;
    private static final int STICKY = 01000;
    private static final int OPEN_TO_OTHERS = 0077;
    private static @Nullable Path found;

    private NativeFolder() {}

    /**
     * Loads native code. While this runs, the system property {@code java.io.tmpdir}, from which libraries derive where
     * they unpack their code, names the private folder.
     *
     * @param loading loads one library, on this thread
     * @return what {@code loading} returns
     * @throws IOException if no folder is private and allows the execution of code; nothing was loaded, and the message
     *     names the folders that were tried and the remedy
     */
    public static synchronized <T> T load(Supplier<T> loading) throws IOException {
        prepare();
        String usual = System.getProperty(TEMPORARY);
        System.setProperty(TEMPORARY, String.valueOf(found));
        try {
            return loading.get();
        } finally {
            System.setProperty(TEMPORARY, usual);
        }
    }

    /**
     * Sets the system properties by which JNA and JLine choose where they unpack their code, unless they are set.
     *
     * @throws IOException as {@link #load}
     */
    public static synchronized void prepare() throws IOException {
        if (found == null) {
            found = find(candidates(System.getenv(), System.getProperty("os.name"), System.getProperty("user.home")));
        }
        for (String property : List.of("jna.tmpdir", "jline.tmpdir")) {
            if (System.getProperty(property) == null) {
                System.setProperty(property, found.toString());
            }
        }
    }

    /** The folders to try, in this order; the folder that the user has chosen is the only one. */
    static List<Supplier<Path>> candidates(Map<String, String> environment, String system, String home) {
        String chosen = environment.getOrDefault(CHOICE, "");
        if (!chosen.isBlank()) {
            return List.of(() -> Path.of(chosen, "majic-native"));
        }
        Path cache = cache(environment, system.toLowerCase(Locale.ROOT), home);
        List<Supplier<Path>> all = new ArrayList<>();
        if (cache.isAbsolute()) {
            all.add(() -> cache);
        }
        all.add(NativeFolder::temporary);
        return all;
    }

    private static Path cache(Map<String, String> environment, String system, String home) {
        if (system.contains("win") && environment.containsKey("LOCALAPPDATA")) {
            return Path.of(environment.get("LOCALAPPDATA"), "MAJIC", "native");
        }
        if (system.contains("mac")) {
            return Path.of(home, "Library", "Caches", "MAJIC", "native");
        }
        String caches = environment.getOrDefault("XDG_CACHE_HOME", "");
        return caches.isBlank() ? Path.of(home, ".cache", "majic", "native") : Path.of(caches, "majic", "native");
    }

    /** A new folder with an unpredictable name, which only its owner may use, for this run of the program. */
    private static Path temporary() {
        try {
            Path folder = Files.createTempDirectory("majic-native");
            Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(folder), "native code"));
            return folder;
        } catch (IOException e) {
            return Path.of(System.getProperty(TEMPORARY), "majic-native");
        }
    }

    private static void delete(Path folder) {
        try (Stream<Path> all = Files.walk(folder)) {
            all.sorted(Comparator.reverseOrder()).forEach(path -> path.toFile().delete());
        } catch (IOException e) {
            folder.toFile().delete();
        }
    }

    /**
     * Returns the first folder that is private and allows execution; creates it.
     *
     * @throws IOException if there is none
     */
    static Path find(List<Supplier<Path>> candidates) throws IOException {
        List<String> refused = new ArrayList<>();
        for (Supplier<Path> candidate : candidates) {
            Path folder = candidate.get();
            try {
                return checked(folder);
            } catch (Unsuitable e) {
                refused.add(folder + " " + e.getMessage());
            } catch (IOException | UnsupportedOperationException e) {
                refused.add(folder + " cannot be created");
            }
        }
        throw new IOException("native code can be loaded from no folder of this user: " + String.join(", ", refused)
                + "; can the environment variable " + CHOICE
                + " name a folder of yours on a file system that is not mounted with noexec?");
    }

    /** A folder that is not used, with half a sentence that says why. */
    private static final class Unsuitable extends IOException {
        private static final long serialVersionUID = 1;

        Unsuitable(String reason) {
            super(reason);
        }
    }

    private static Path checked(Path wanted) throws IOException {
        Files.createDirectories(wanted.getParent());
        Path folder = wanted.getParent().toRealPath().resolve(wanted.getFileName());
        try {
            Files.createDirectory(folder, onlyForOwner(folder));
        } catch (FileAlreadyExistsException e) {
            if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
                throw new Unsuitable("is not a folder");
            }
        }
        Path sample = Files.createTempFile(folder, "sample", "", onlyForOwner(folder));
        try {
            checkPrivate(folder, sample);
            if (!Files.isExecutable(sample)) {
                throw new Unsuitable("allows no execution (noexec)");
            }
        } finally {
            Files.delete(sample);
        }
        return folder;
    }

    /** The owner of a new file is this user. Windows gives a new folder the access list of the user's profile. */
    private static void checkPrivate(Path folder, Path sample) throws IOException {
        if (!hasModes(folder)) {
            return;
        }
        if (!Files.getAttribute(folder, "unix:uid").equals(Files.getAttribute(sample, "unix:uid"))) {
            throw new Unsuitable("belongs to another user");
        }
        if ((mode(folder) & OPEN_TO_OTHERS) != 0) {
            throw new Unsuitable("is open to other users");
        }
        for (Path above = folder.getParent(); above != null; above = above.getParent()) {
            if ((mode(above) & WRITABLE_BY_OTHERS) != 0 && (mode(above) & STICKY) == 0) {
                throw new Unsuitable("can be replaced by other users, who may write to " + above);
            }
        }
    }

    private static FileAttribute<?>[] onlyForOwner(Path folder) {
        return hasModes(folder)
                ? new FileAttribute<?>[] {
                    PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"))
                }
                : new FileAttribute<?>[0];
    }

    private static boolean hasModes(Path folder) {
        return folder.getFileSystem().supportedFileAttributeViews().contains("unix");
    }

    private static int mode(Path path) throws IOException {
        return (Integer) Files.getAttribute(path, "unix:mode");
    }
}

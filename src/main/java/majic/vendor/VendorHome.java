package majic.vendor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;

/**
 * The folder in which a library is installed.
 *
 * @param folder absolute
 * @param from how it is known, for messages
 */
record VendorHome(Path folder, String from) {
    /** Where jars and native libraries are, on the systems there are installers for; empty for the folder itself. */
    private static final List<String> SUBFOLDERS = List.of("", "java", "lib", "lib64", "bin", "bin64", "dist");

    private static final String PLACES = "it or its folders java, lib, lib64, bin, bin64, dist";

    static VendorHome find(VendorLibrary library, Settings settings) {
        return find(library, settings, System::getProperty, System::getenv);
    }

    /**
     * Finds the folder that is named for a library.
     *
     * @throws BotException if none is, or it does not exist
     */
    static VendorHome find(
            VendorLibrary library,
            Settings settings,
            Function<String, @Nullable String> properties,
            Function<String, @Nullable String> environment) {
        return named(properties.apply(library.property()), library.option())
                .or(() ->
                        named(environment.apply(library.variable()), "the environment variable " + library.variable()))
                .or(() -> named(settings.get(library.property()).orElse(null), "the setting " + library.property()))
                .orElseThrow(() -> new BotException(library.label()
                        + " is not found: name the folder where it is installed with "
                        + library.option() + " DIR, in the environment variable " + library.variable() + ", or as "
                        + library.property() + " in MAJIC's settings"))
                .checked(library);
    }

    private static Optional<VendorHome> named(@Nullable String folder, String from) {
        return folder == null || folder.isBlank() ? Optional.empty() : Optional.of(of(folder.strip(), from));
    }

    private static VendorHome of(String folder, String from) {
        try {
            return new VendorHome(path(folder).toAbsolutePath().normalize(), from);
        } catch (InvalidPathException e) {
            throw new BotException(from + " names no folder: " + folder, e);
        }
    }

    /** Takes a ~ as shells do, which leave it as it is in {@code --option=~/folder}; settings go through none. */
    private static Path path(String folder) {
        return folder.equals("~") || folder.startsWith("~/")
                ? Path.of(System.getProperty("user.home") + folder.substring(1))
                : Path.of(folder);
    }

    private VendorHome checked(VendorLibrary library) {
        if (!Files.isDirectory(folder)) {
            throw new BotException(library.label() + " is not found: there is no folder " + this);
        }
        return this;
    }

    /** Finds the jar, or the folder of classes, that has a library's classes. */
    Path classes(VendorLibrary library) {
        String mark = library.mark().replace('.', '/') + ".class";
        return SUBFOLDERS.stream()
                .map(folder::resolve)
                .flatMap(VendorHome::withJars)
                .filter(place -> has(place, mark))
                .findFirst()
                .orElseThrow(() -> new BotException(library.label() + " is not found: no jar in " + this
                        + ", neither in " + PLACES + ", has the class " + library.mark()));
    }

    private static Stream<Path> withJars(Path place) {
        if (!Files.isDirectory(place)) {
            return Stream.of();
        }
        try (Stream<Path> files = Files.list(place)) {
            List<Path> jars = files.filter(file -> file.toString().endsWith(".jar"))
                    .sorted()
                    .toList();
            return Stream.concat(Stream.of(place), jars.stream());
        } catch (IOException e) {
            return Stream.of(place);
        }
    }

    private static boolean has(Path place, String mark) {
        if (Files.isDirectory(place)) {
            return Files.exists(place.resolve(mark));
        }
        try (JarFile jar = new JarFile(place.toFile())) {
            return jar.getEntry(mark) != null;
        } catch (IOException e) {
            return false;
        }
    }

    /** Finds a native library by its name without what the system puts around it. */
    Optional<Path> nativeLibrary(String name) {
        String file = System.mapLibraryName(name);
        return SUBFOLDERS.stream()
                .map(sub -> folder.resolve(sub).resolve(file))
                .filter(Files::isRegularFile)
                .findFirst();
    }

    /** Finds a native library that must be there. */
    Path requiredLibrary(VendorLibrary library, String name) {
        return nativeLibrary(name)
                .orElseThrow(() -> new BotException(library.label() + " is not complete: there is no "
                        + System.mapLibraryName(name) + " in " + this + ", neither in " + PLACES));
    }

    @Override
    public String toString() {
        return folder + " (from " + from + ")";
    }
}

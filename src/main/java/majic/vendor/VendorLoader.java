package majic.vendor;

import java.io.IOException;
import java.io.InputStream;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * Defines the classes of one library and of the adapter that uses it; all others come from the program's class loader.
 * The adapter's classes are part of the program but are defined here from their bytes, so that the library's names in
 * them mean the installed one. The library's classes are never looked for in the program.
 */
final class VendorLoader extends URLClassLoader {
    private static final Pattern OTHER_PROCESSOR =
            Pattern.compile("wrong ELF class|32-bit|64-bit|(wrong|incompatible) architecture");

    private final VendorLibrary library;
    private final VendorHome home;
    private final String adapter;
    private boolean hasNatives;

    private VendorLoader(VendorLibrary library, VendorHome home, String adapter, URL classes) {
        super(library.label(), new URL[] {classes}, VendorLoader.class.getClassLoader());
        this.library = library;
        this.home = home;
        this.adapter = adapter;
    }

    /**
     * Finds a library's classes in its folder.
     *
     * @param adapter the adapter's package, with a dot at its end
     * @throws BotException if they are missing
     */
    static VendorLoader find(VendorLibrary library, VendorHome home, String adapter) {
        return new VendorLoader(library, home, adapter, url(home.classes(library)));
    }

    /**
     * Loads the native parts that are not loaded yet. After a failure it can be called again, and only for the same
     * loader: Java loads no file for two of them.
     *
     * @throws BotException if a part is missing or cannot be loaded
     */
    void loadNatives() {
        for (String name : library.natives()) {
            boolean required =
                    name.equals(library.natives().get(library.natives().size() - 1));
            if (required) {
                load(home.requiredLibrary(library, name));
            } else {
                home.nativeLibrary(name).ifPresent(this::load);
            }
        }
    }

    /** Whether any native part is loaded. */
    boolean hasNatives() {
        return hasNatives;
    }

    private static URL url(Path classes) {
        try {
            return classes.toUri().toURL();
        } catch (MalformedURLException e) {
            throw new BotException(classes + " cannot be read as a jar", e);
        }
    }

    Path home() {
        return home.folder();
    }

    /**
     * Loads a file by its absolute path, so that those loaded after it find it although no search path names its
     * folder.
     */
    @SuppressWarnings("unchecked")
    private void load(Path file) {
        try {
            ((Consumer<Path>) loadClass(NativeLoading.class.getName())
                            .getConstructor()
                            .newInstance())
                    .accept(file);
            hasNatives = true;
        } catch (ReflectiveOperationException | LinkageError e) {
            String reason = String.valueOf(e.getMessage());
            throw new BotException(explain(file, reason), e);
        }
    }

    private String explain(Path file, String reason) {
        if (OTHER_PROCESSOR.matcher(reason).find()) {
            return library.label() + " does not fit this Java: " + file + " is made for another processor than "
                    + System.getProperty("os.arch") + "; install its build for that";
        }
        String advice = reason.contains("cannot open shared object file")
                ? "; it needs another library: start MAJIC with the environment variable LD_LIBRARY_PATH="
                        + file.getParent()
                : "";
        return library.label() + " cannot be loaded from " + file + ": " + reason + advice;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!isDefinedHere(name)) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> known = findLoadedClass(name);
            return known == null ? findClass(name) : known;
        }
    }

    private boolean isDefinedHere(String name) {
        return name.startsWith(library.packages())
                || name.startsWith(adapter)
                || name.equals(NativeLoading.class.getName());
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        return name.startsWith(library.packages()) ? super.findClass(name) : define(name);
    }

    /** Defines a class of the program. */
    private Class<?> define(String name) throws ClassNotFoundException {
        try (InputStream file = getParent().getResourceAsStream(name.replace('.', '/') + ".class")) {
            if (file == null) {
                throw new ClassNotFoundException(name);
            }
            byte[] bytes = file.readAllBytes();
            return defineClass(name, bytes, 0, bytes.length);
        } catch (IOException e) {
            throw new ClassNotFoundException(name, e);
        }
    }

    @Override
    protected @Nullable String findLibrary(String name) {
        return home.nativeLibrary(name).map(Path::toString).orElse(null);
    }
}

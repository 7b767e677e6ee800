package majic.act.file;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Loads the classes of one act's file, before those of the same name that MAJIC has. The classes are unloaded when the
 * act is no longer used.
 */
public final class ActClassLoader extends ClassLoader {
    private final Map<String, byte[]> entries;

    /**
     * Creates a loader for one load of one file.
     *
     * @param label the file's name, shown in dumps of threads and classes
     * @param entries the file's entries by path, already checked to hold no class of a reserved package
     */
    public ActClassLoader(String label, Map<String, byte[]> entries, ClassLoader majic) {
        super("act " + label, majic);
        this.entries = entries;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            byte[] code = entries.get(ClassNames.pathOf(name));
            if (loaded == null) {
                loaded = code == null || ClassNames.isReserved(name)
                        ? super.loadClass(name, false)
                        : defineClass(name, code, 0, code.length);
            }
            if (resolve) {
                resolveClass(loaded);
            }
            return loaded;
        }
    }

    @Override
    public @Nullable InputStream getResourceAsStream(String path) {
        byte[] own = entries.get(path);
        return own == null ? super.getResourceAsStream(path) : new ByteArrayInputStream(own);
    }
}

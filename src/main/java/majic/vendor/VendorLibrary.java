package majic.vendor;

import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import majic.bot.BotException;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;

/**
 * A robot maker's Java library, by which a robot can be driven instead of by this program's own client. The program has
 * no part of it: it is looked for when it is first needed, and stays loaded until the program ends. Thread-safe.
 */
public enum VendorLibrary {
    /** MobileRobots' ARIA, with its Java wrapper. */
    ARIA("ARIA", "aria", "com.mobilerobots.", "Aria.ArRobot", List.of("Aria", "AriaJava")),
    /** The pure Java liburbi of 2004. */
    LIBURBI("liburbi-java", "liburbi", "liburbi.", "UClient", List.of());

    private final String label;
    private final String word;
    private final String packages;
    private final String mark;
    private final List<String> natives;
    private @Nullable VendorLoader loader;

    VendorLibrary(String label, String word, String packages, String mark, List<String> natives) {
        this.label = label;
        this.word = word;
        this.packages = packages;
        this.mark = packages + mark;
        this.natives = natives;
    }

    /**
     * Its name for users.
     *
     * @return such as {@code ARIA}
     */
    public String label() {
        return label;
    }

    /**
     * Its name in addresses, behind the robot's type and a plus sign.
     *
     * @return lower-case letters: {@code aria} as in {@code pioneer+aria://10.0.0.5}
     */
    public String word() {
        return word;
    }

    /**
     * The command-line option for the folder in which it is installed.
     *
     * @return such as {@code --aria-home}
     */
    public String option() {
        return "--" + word + "-home";
    }

    /**
     * The system property for that folder, which the option sets, and the name of the setting.
     *
     * @return such as {@code aria.home}
     */
    public String property() {
        return word + ".home";
    }

    /**
     * The environment variable for that folder.
     *
     * @return such as {@code ARIA}
     */
    public String variable() {
        return word.toUpperCase(Locale.ROOT);
    }

    /** The start of the names of all its packages. */
    String packages() {
        return packages;
    }

    /** The class by which its jar is recognised. */
    String mark() {
        return mark;
    }

    /** Its native libraries, those that others need first. Only the last one must be in its folder. */
    List<String> natives() {
        return natives;
    }

    /**
     * Creates an object of an adapter class, which uses the library. The library is looked for in the folder named by
     * the command line, the environment or the settings, in this order.
     *
     * @param <T> the type by which the rest of the driver uses the adapter
     * @param type that interface, which is not in the adapter's package
     * @param adapter the name of a public class with a public constructor without arguments; all classes of its package
     *     are loaded together with the library, and must be used by nothing else
     * @param settings may name the folder
     * @return a new object
     * @throws BotException if the library is missing or cannot be used; the message says what was looked for and where
     */
    public synchronized <T> T create(Class<T> type, String adapter, Settings settings) {
        VendorHome home = VendorHome.find(this, settings);
        try {
            return type.cast(
                    loader(home, adapter).loadClass(adapter).getConstructor().newInstance());
        } catch (ReflectiveOperationException | LinkageError e) {
            Throwable cause = e instanceof InvocationTargetException ? e.getCause() : e;
            throw new BotException(
                    label + " in " + home + " is not the version that MAJIC can use, or damaged: " + cause, e);
        }
    }

    /**
     * Returns the folder in which the library is installed. For adapters, which exist only while the library is loaded.
     *
     * @return the folder, absolute
     * @throws IllegalStateException if the library is not loaded
     */
    public synchronized Path home() {
        if (loader == null) {
            throw new IllegalStateException(label + " is not loaded");
        }
        return loader.home();
    }

    private VendorLoader loader(VendorHome home, String adapter) {
        VendorLoader known = loader;
        if (known != null && known.home().equals(home.folder())) {
            known.loadNatives();
            return known;
        }
        if (known != null && known.hasNatives()) {
            throw new BotException(label + " was loaded from " + known.home()
                    + ", and only one can be loaded; restart MAJIC to use " + home);
        }
        VendorLoader fresh = VendorLoader.find(this, home, adapter.substring(0, adapter.lastIndexOf('.') + 1));
        loader = fresh;
        fresh.loadNatives();
        return fresh;
    }
}

package majic.program;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import majic.bot.BotType;

/** Finds the types of robots: those in MAJIC's jar, and those in jars in the plug-ins folder. */
public final class Plugins {
    private static final System.Logger LOG = System.getLogger(Plugins.class.getName());

    /** The types in the order of the thesis; types from plug-ins follow by name. */
    private static final List<String> ORDER = List.of("aibo", "pioneer", "hemisson");

    private Plugins() {}

    /**
     * Returns all types of robots.
     *
     * @param folder the plug-ins folder; need not exist
     * @return the types; a broken plug-in is logged and left out
     */
    public static List<BotType> types(Path folder) {
        List<BotType> types = new ArrayList<>();
        Iterator<BotType> found =
                ServiceLoader.load(BotType.class, loader(folder)).iterator();
        while (takeNext(found, types)) {
            LOG.log(Level.DEBUG, "{0} type(s) of robots so far", types.size());
        }
        types.sort(Comparator.comparingInt(Plugins::place).thenComparing(BotType::name));
        return types;
    }

    /** Adds the next type; returns false at the end. A type that cannot be instantiated is skipped. */
    private static boolean takeNext(Iterator<BotType> found, List<BotType> types) {
        try {
            boolean more = found.hasNext();
            if (more) {
                types.add(found.next());
            }
            return more;
        } catch (ServiceConfigurationError | LinkageError e) {
            LOG.log(Level.WARNING, "a plug-in cannot be used: " + e.getMessage(), e);
            return true;
        }
    }

    private static int place(BotType type) {
        int place = ORDER.indexOf(type.name());
        return place < 0 ? ORDER.size() : place;
    }

    private static ClassLoader loader(Path folder) {
        ClassLoader own = Plugins.class.getClassLoader();
        List<URL> jars = jars(folder);
        return jars.isEmpty() ? own : new URLClassLoader("plug-ins", jars.toArray(URL[]::new), own);
    }

    private static List<URL> jars(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            List<URL> jars = new ArrayList<>();
            for (Path jar :
                    files.filter(file -> file.toString().endsWith(".jar")).toList()) {
                jars.add(url(jar));
            }
            return jars;
        } catch (IOException e) {
            LOG.log(Level.WARNING, "cannot look into the plug-ins folder " + folder, e);
            return List.of();
        }
    }

    private static URL url(Path jar) throws MalformedURLException {
        return jar.toUri().toURL();
    }
}

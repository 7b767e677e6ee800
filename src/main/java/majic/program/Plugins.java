package majic.program;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import majic.bot.BotType;
import majic.team.BotFactory;

/** Finds the types of robots: those in MAJIC's jar, and those in jars in the plug-ins folder. */
public final class Plugins {
    private static final System.Logger LOG = System.getLogger(Plugins.class.getName());

    private Plugins() {}

    /**
     * Returns all types of robots.
     *
     * @param folder the plug-ins folder; need not exist
     * @return the types; a broken plug-in is logged and left out
     */
    public static List<BotType> types(Path folder) {
        return BotFactory.types(loader(folder));
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

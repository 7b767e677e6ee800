package majic.program;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.text.ClassReason;
import majic.text.IoReason;
import org.jspecify.annotations.Nullable;

/**
 * A plug-in: a jar {@code NAME.jar} in the plug-ins folder, or a folder {@code NAME} in it with {@code NAME.jar} and
 * the libraries of the plug-in, {@code lib/*.jar}. It has a class loader of its own, so that two plug-ins may bring
 * different versions of a library; what MAJIC has itself is taken from MAJIC.
 */
final class Plugin {
    private static final String SERVICES = "META-INF/services/" + BotType.class.getName();
    private static final String JAR = ".jar";
    private static final Pattern CLASS = Pattern.compile("[\\p{L}_$][\\w$\\p{L}]*(\\.[\\p{L}_$][\\w$\\p{L}]*)*");
    private static final Pattern TYPE = Pattern.compile("[a-z][a-z0-9]*");

    private final Path jar;
    private final @Nullable Path libraries;
    private @Nullable ClassLoader loader;

    private Plugin(Path jar, @Nullable Path libraries) {
        this.jar = jar;
        this.libraries = libraries;
    }

    /** Returns whether an entry of the plug-ins folder is a plug-in: a jar, or a folder that is not hidden. */
    static boolean isPlugin(Path entry) {
        return !entry.getFileName().toString().startsWith(".")
                && (entry.toString().endsWith(JAR) || Files.isDirectory(entry));
    }

    /** Returns the plug-in of such an entry; reads nothing yet. */
    static Plugin at(Path entry) {
        return Files.isDirectory(entry)
                ? new Plugin(entry.resolve(entry.getFileName() + JAR), entry.resolve("lib"))
                : new Plugin(entry, null);
    }

    /** Returns its jar as messages name it, relative to the plug-ins folder. */
    String name() {
        Path folder = libraries == null ? jar.getParent() : jar.getParent().getParent();
        return folder.relativize(jar).toString();
    }

    /**
     * Reads which classes the plug-in names as types of robots; loads none.
     *
     * @throws PluginProblem if the jar or one of the libraries cannot be read, or it names none
     */
    List<String> typeClasses() throws PluginProblem {
        List<String> named = new ArrayList<>();
        for (String line : read(jar).lines().toList()) {
            String name = line.replaceFirst("#.*", "").strip();
            if (!name.isEmpty()) {
                named.add(name);
            }
        }
        if (named.isEmpty()) {
            throw new PluginProblem("it names no type of robot: the file " + SERVICES + " in it has to contain the"
                    + " name of a class; a library belongs into the folder lib of its plug-in");
        }
        loader = loader();
        return named;
    }

    /** The text of the file that names the types; empty if there is none. */
    private static String read(Path file) throws PluginProblem {
        if (!Files.exists(file)) {
            throw new PluginProblem("there is no such file; a plug-in folder has to contain a jar of its own name");
        }
        try (JarFile opened = new JarFile(file.toFile())) {
            ZipEntry services = opened.getEntry(SERVICES);
            if (services == null) {
                return "";
            }
            try (InputStream bytes = opened.getInputStream(services)) {
                return new String(bytes.readAllBytes(), StandardCharsets.UTF_8);
            }
        } catch (ZipException e) {
            throw new PluginProblem("it is damaged or not a jar: " + IoReason.of(e), e);
        } catch (IOException e) {
            throw new PluginProblem("it cannot be read: " + IoReason.of(e), e);
        }
    }

    private ClassLoader loader() throws PluginProblem {
        try {
            List<URL> jars = new ArrayList<>(List.of(url(jar)));
            for (Path library : libraryJars()) {
                checkLibrary(library);
                jars.add(url(library));
            }
            return new URLClassLoader("plug-in " + name(), jars.toArray(URL[]::new), Plugin.class.getClassLoader());
        } catch (IOException e) {
            throw new PluginProblem("its libraries cannot be read: " + IoReason.of(e), e);
        }
    }

    private List<Path> libraryJars() throws IOException {
        if (libraries == null || !Files.isDirectory(libraries)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(libraries)) {
            return files.filter(file -> file.toString().endsWith(JAR)).sorted().toList();
        }
    }

    /** A class loader ignores a damaged jar, and its classes are missing later. */
    private void checkLibrary(Path library) throws PluginProblem {
        try (JarFile opened = new JarFile(library.toFile())) {
            opened.size();
        } catch (IOException e) {
            throw new PluginProblem(
                    "its library " + library.getFileName() + " is damaged or not a jar: " + IoReason.of(e), e);
        }
    }

    private static URL url(Path file) throws MalformedURLException {
        return file.toUri().toURL();
    }

    /**
     * Makes a type of robot.
     *
     * @param className one of {@link #typeClasses()}
     * @throws PluginProblem if the class is missing, cannot be loaded, is no {@code BotType}, fails, or has an invalid
     *     name
     */
    BotType type(String className) throws PluginProblem {
        if (!CLASS.matcher(className).matches()) {
            throw new PluginProblem("\"" + className + "\" in " + SERVICES + " is not the name of a class");
        }
        try {
            Object made = load(className).getConstructor().newInstance();
            return checked((BotType) made);
        } catch (NoSuchMethodException | IllegalAccessException | InstantiationException e) {
            throw new PluginProblem(
                    className + " has to be a public class with a public constructor without arguments", e);
        } catch (InvocationTargetException e) {
            throw failed(className, e.getCause());
        } catch (RuntimeException | Error e) {
            throw failed(className, e);
        }
    }

    private Class<?> load(String className) throws PluginProblem {
        try {
            Class<?> found = Class.forName(className, false, loader);
            if (!BotType.class.isAssignableFrom(found)) {
                throw new PluginProblem(
                        className + " in " + SERVICES + " does not implement " + BotType.class.getName());
            }
            return found;
        } catch (ClassNotFoundException e) {
            throw new PluginProblem(
                    "the class " + className + " is missing, which " + SERVICES + " names" + nested(className), e);
        }
    }

    /** A class within a class is named with a dollar sign in the file. */
    private static String nested(String className) {
        int dot = className.lastIndexOf('.');
        int outer = className.lastIndexOf('.', dot - 1) + 1;
        return dot > 0 && Character.isUpperCase(className.charAt(outer))
                ? "; a class within a class is named " + className.substring(0, dot) + "$"
                        + className.substring(dot + 1)
                : "";
    }

    private static PluginProblem failed(String className, @Nullable Throwable cause) {
        String reason =
                cause instanceof LinkageError linkage ? ClassReason.of(linkage) : className + " fails: " + cause;
        return new PluginProblem(reason, cause);
    }

    private static BotType checked(BotType type) throws PluginProblem {
        String name = type.name();
        if (name == null || !TYPE.matcher(name).matches() || name.equals(BotAddress.SIMULATED)) {
            throw new PluginProblem("\"" + name + "\" cannot be the name of a type of robot, which has to be a word in"
                    + " lower-case letters other than \"" + BotAddress.SIMULATED + "\"");
        }
        if (type.label() == null || type.make() == null || type.reaches().isEmpty()) {
            throw new PluginProblem("the type " + name + " has to have a label, a make and a kind of connection");
        }
        return type;
    }
}

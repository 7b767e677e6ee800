package majic.shared.embedded;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/** The classes of the embedded broker, which MAJIC calls by name: it is compiled without them. */
final class BrokerLibraries implements AutoCloseable {
    private static final String MAIN_JAR = "hivemq-community-edition-embedded";

    private final URLClassLoader loader;

    /** Answers the calls of an interface of the broker. */
    @FunctionalInterface
    interface Answer {
        /** Returns the result of one call; null for void. */
        @Nullable
        Object to(String method, Object[] arguments);
    }

    private BrokerLibraries(URLClassLoader loader) {
        this.loader = loader;
    }

    /**
     * Returns the folder of the libraries beside the program: {@code broker} beside its jar, or {@code target/broker}.
     */
    static Path folder() {
        try {
            URI program = BrokerLibraries.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI();
            return Path.of(program).resolveSibling("broker");
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Loads the libraries.
     *
     * @param jars their folder
     * @param configuration a folder that is searched first
     * @throws BotException if they are missing; the message says how to get them, or another broker
     */
    static BrokerLibraries load(Path jars, Path configuration) {
        List<URL> urls = new ArrayList<>();
        try (Stream<Path> files = Files.isDirectory(jars) ? Files.list(jars) : Stream.empty()) {
            urls.add(configuration.toUri().toURL());
            for (Path jar :
                    files.filter(file -> file.toString().endsWith(".jar")).toList()) {
                urls.add(jar.toUri().toURL());
            }
        } catch (IOException e) {
            throw new BotException("the libraries of the embedded broker cannot be read: " + e.getMessage(), e);
        }
        if (urls.stream().noneMatch(url -> url.getPath().contains(MAIN_JAR))) {
            throw new BotException(
                    "the embedded broker is not installed: start MAJIC from its sources with ./majic --broker,"
                            + " which fetches it once, or install another broker, such as Mosquitto");
        }
        return new BrokerLibraries(
                new URLClassLoader("broker", urls.toArray(URL[]::new), ClassLoader.getPlatformClassLoader()));
    }

    ClassLoader loader() {
        return loader;
    }

    /**
     * Calls a method of a type.
     *
     * @param type the class or interface that declares the method
     * @param target null for a static method
     * @throws BotException if it throws
     */
    @Nullable
    Object call(String type, @Nullable Object target, String name, Object... arguments) {
        try {
            Method method = Arrays.stream(loader.loadClass(type).getMethods())
                    .filter(one -> one.getName().equals(name) && accepts(one.getParameterTypes(), arguments))
                    .findFirst()
                    .orElseThrow(() -> new NoSuchMethodException(type + "." + name));
            return method.invoke(target, arguments);
        } catch (InvocationTargetException e) {
            throw new BotException("the embedded broker failed: " + e.getCause(), e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new BotException("the embedded broker is of another version: " + e.getMessage(), e);
        }
    }

    private static boolean accepts(Class<?>[] types, Object... arguments) {
        if (types.length != arguments.length) {
            return false;
        }
        for (int i = 0; i < types.length; i++) {
            if (!types[i].isPrimitive() && !types[i].isInstance(arguments[i])) {
                return false;
            }
        }
        return true;
    }

    /** Implements an interface of the broker. */
    Object implement(String type, Answer answer) {
        try {
            return Proxy.newProxyInstance(
                    loader,
                    new Class<?>[] {loader.loadClass(type)},
                    (proxy, method, arguments) -> switch (method.getName()) {
                        case "hashCode" -> System.identityHashCode(proxy);
                        case "equals" -> proxy == arguments[0];
                        case "toString" -> "MAJIC's " + type;
                        default -> answer.to(method.getName(), arguments);
                    });
        } catch (ClassNotFoundException e) {
            throw new BotException("the embedded broker is of another version: " + e.getMessage(), e);
        }
    }

    @Override
    public void close() {
        try {
            loader.close();
        } catch (IOException e) {
            throw new BotException("the libraries of the embedded broker cannot be closed: " + e.getMessage(), e);
        }
    }
}

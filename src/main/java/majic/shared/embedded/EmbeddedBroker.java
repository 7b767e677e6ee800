package majic.shared.embedded;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.logging.Handler;
import java.util.logging.Logger;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * An MQTT 5 broker inside this program: HiveMQ CE. It keeps its messages in memory and its files in a temporary folder,
 * which is deleted at the end. It writes no log.
 */
public final class EmbeddedBroker implements AutoCloseable {
    private static final String BROKER = "com.hivemq.embedded.EmbeddedHiveMQ";
    private static final String BUILDER = "com.hivemq.embedded.EmbeddedHiveMQBuilder";
    private static final int START_SECONDS = 60;
    private static final int STOP_SECONDS = 10;

    private final BrokerFiles files;
    private final BrokerLibraries libraries;
    private @Nullable Object broker;

    private EmbeddedBroker(BrokerFiles files, BrokerLibraries libraries) {
        this.files = files;
        this.libraries = libraries;
    }

    /**
     * Starts a broker with the libraries beside this program. Blocks for some seconds.
     *
     * @param options where it listens, and the user that may connect
     * @return the running broker
     * @throws BotException if the libraries are missing, the port is taken, or it fails; nothing stays open
     */
    public static EmbeddedBroker start(EmbeddedOptions options) {
        return start(BrokerLibraries.folder(), options);
    }

    /**
     * Returns whether the libraries are there.
     *
     * @return false if {@link #start} would refuse for this reason
     */
    public static boolean isInstalled() {
        return BrokerLibraries.folder().toFile().isDirectory();
    }

    static EmbeddedBroker start(Path jars, EmbeddedOptions options) {
        requireFree(options);
        BrokerFiles files = new BrokerFiles(options);
        try {
            BrokerLibraries libraries = BrokerLibraries.load(jars, files.part("log"));
            EmbeddedBroker started = new EmbeddedBroker(files, libraries);
            started.begin(options);
            return started;
        } catch (RuntimeException e) {
            files.close();
            throw e;
        }
    }

    /** The broker itself would only log that its port is taken. */
    private static void requireFree(EmbeddedOptions options) {
        try (ServerSocket socket = new ServerSocket(
                options.address().getPort(), 1, options.address().getAddress())) {
            socket.getLocalPort();
        } catch (IOException e) {
            throw new BotException(
                    "the broker cannot listen at " + options + ": " + e.getMessage()
                            + "; does another broker run there? Then it can be used as it is",
                    e);
        }
    }

    private void begin(EmbeddedOptions options) {
        Handler[] handlers = Logger.getLogger("").getHandlers();
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        Thread.currentThread().setContextClassLoader(libraries.loader());
        try {
            broker = build(options);
            await((CompletableFuture<?>) libraries.call(BROKER, broker, "start"), START_SECONDS);
        } catch (RuntimeException e) {
            libraries.close();
            throw e;
        } finally {
            Thread.currentThread().setContextClassLoader(before);
            restore(handlers);
        }
    }

    private Object build(EmbeddedOptions options) {
        Object builder = libraries.call(BROKER, null, "builder");
        libraries.call(BUILDER, builder, "withConfigurationFolder", files.part("conf"));
        libraries.call(BUILDER, builder, "withDataFolder", files.part("data"));
        libraries.call(BUILDER, builder, "withExtensionsFolder", files.part("extensions"));
        String user = options.user();
        String password = options.password();
        if (user != null && password != null) {
            Object extension = new PasswordExtension(libraries, user, password).extension();
            libraries.call(BUILDER, builder, "withEmbeddedExtension", Objects.requireNonNull(extension));
        }
        return Objects.requireNonNull(libraries.call(BUILDER, builder, "build"));
    }

    /** The broker takes the log of the whole Java program to itself when it starts. */
    private static void restore(Handler... handlers) {
        Logger root = Logger.getLogger("");
        for (Handler added : root.getHandlers()) {
            root.removeHandler(added);
        }
        for (Handler kept : handlers) {
            root.addHandler(kept);
        }
    }

    private static void await(@Nullable CompletableFuture<?> outcome, int seconds) {
        try {
            Objects.requireNonNull(outcome).get(seconds, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            throw new BotException("the embedded broker failed: " + e.getCause().getMessage(), e);
        } catch (TimeoutException e) {
            throw new BotException("the embedded broker did not answer within " + seconds + " s", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted while waiting for the embedded broker", e);
        }
    }

    /** Ends the broker and deletes its files. Blocks for at most 10 s. */
    @Override
    public void close() {
        try {
            await((CompletableFuture<?>) libraries.call(BROKER, broker, "stop"), STOP_SECONDS);
        } finally {
            libraries.close();
            files.close();
        }
    }
}

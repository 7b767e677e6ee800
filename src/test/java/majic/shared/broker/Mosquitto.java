package majic.shared.broker;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import majic.link.Loopback;

/** A Mosquitto on a free port of this computer, with a configuration of its own; killed by {@link #close}. */
public final class Mosquitto implements AutoCloseable {
    private final Process process;
    private final int port;

    private Mosquitto(Process process, int port) {
        this.process = process;
        this.port = port;
    }

    /** Where it is installed; empty if it is not. Debian installs it where only the administrator's path leads. */
    public static Optional<Path> installed() {
        return Stream.concat(
                        Stream.of(System.getenv("PATH").split(File.pathSeparator)),
                        Stream.of("/usr/sbin", "/usr/local/sbin"))
                .map(folder -> Path.of(folder, "mosquitto"))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /** Starts it on a free port, open to all programs of this computer. */
    public static Mosquitto start(Path folder) {
        return start(folder, Loopback.freePort(), "allow_anonymous true");
    }

    /** Starts it on a port with further lines of configuration, and waits until it accepts connections. */
    public static Mosquitto start(Path folder, int port, String... lines) {
        List<String> configuration = new ArrayList<>(List.of(
                "listener " + port + " 127.0.0.1", "persistence false", "user " + System.getProperty("user.name")));
        configuration.addAll(List.of(lines));
        try {
            Path file = Files.createTempFile(folder, "mosquitto", ".conf");
            Files.write(file, configuration);
            Process process = new ProcessBuilder(installed().orElseThrow().toString(), "-c", file.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(folder.resolve("mosquitto.log").toFile())
                    .start();
            awaitOpen(process, port);
            return new Mosquitto(process, port);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void awaitOpen(Process process, int port) {
        while (process.isAlive()) {
            try {
                new Socket(InetAddress.getByName("127.0.0.1"), port).close();
                return;
            } catch (IOException e) {
                Thread.onSpinWait();
            }
        }
        throw new IllegalStateException("mosquitto ended with " + process.exitValue());
    }

    public int port() {
        return port;
    }

    /** Returns the number of its process. */
    public long pid() {
        return process.pid();
    }

    @Override
    public void close() {
        process.destroyForcibly().onExit().join();
    }
}

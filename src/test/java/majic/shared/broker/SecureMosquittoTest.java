package majic.shared.broker;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.link.Loopback;
import majic.server.ListenKey;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** Mosquitto with TLS and a password, where it is installed. */
@EnabledIf("isInstalled")
class SecureMosquittoTest extends SecureBrokerContract {
    @TempDir
    private static Path folder;

    private static Mosquitto broker;

    static boolean isInstalled() {
        return Mosquitto.installed().isPresent();
    }

    @BeforeAll
    static void start() throws Exception {
        ListenKey.create(folder);
        Path users = Files.writeString(folder.resolve("users"), USER + ":" + PASSWORD + "\n");
        run("mosquitto_passwd", "-U", users.toString());
        broker = Mosquitto.start(
                folder,
                Loopback.freePort(),
                "certfile " + folder.resolve(ListenKey.CERTIFICATE),
                "keyfile " + PemKey.write(folder),
                "allow_anonymous false",
                "password_file " + users);
    }

    private static void run(String... command) throws IOException, InterruptedException {
        int status = new ProcessBuilder(command).inheritIO().start().waitFor();
        if (status != 0) {
            throw new IllegalStateException(command[0] + " ended with " + status);
        }
    }

    @AfterAll
    static void stop() {
        if (broker != null) {
            broker.close();
        }
    }

    @Override
    int port() {
        return broker.port();
    }

    @Override
    Path certificate() {
        return folder.resolve(ListenKey.CERTIFICATE);
    }
}

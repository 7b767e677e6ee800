package majic.shared.broker;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** The connections of this program to Mosquitto, where it is installed. */
@EnabledIf("isInstalled")
class MosquittoContractTest extends RelayedContract {
    @TempDir
    private static Path folder;

    private static Mosquitto broker;

    static boolean isInstalled() {
        return Mosquitto.installed().isPresent();
    }

    @BeforeAll
    static void start() {
        broker = Mosquitto.start(folder);
    }

    @AfterAll
    static void stop() {
        broker.close();
    }

    @Override
    int port() {
        return broker.port();
    }
}

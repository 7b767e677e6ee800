package majic.shared.broker;

import majic.link.Loopback;
import majic.shared.embedded.EmbeddedBroker;
import majic.shared.embedded.EmbeddedOptions;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.condition.EnabledIf;

/** The connections of this program to the embedded broker, whose libraries ./check fetches. */
@EnabledIf("isInstalled")
class EmbeddedContractTest extends RelayedContract {
    private static EmbeddedBroker broker;
    private static int port;

    static boolean isInstalled() {
        return EmbeddedBroker.isInstalled();
    }

    @BeforeAll
    static void start() {
        port = Loopback.freePort();
        broker = EmbeddedBroker.start(EmbeddedOptions.loopback(port));
    }

    @AfterAll
    static void stop() {
        broker.close();
    }

    @Override
    int port() {
        return port;
    }
}

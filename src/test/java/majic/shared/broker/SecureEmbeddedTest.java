package majic.shared.broker;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import majic.link.Loopback;
import majic.server.ListenKey;
import majic.shared.embedded.EmbeddedBroker;
import majic.shared.embedded.EmbeddedOptions;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** The embedded broker with TLS and a password. */
@EnabledIf("isInstalled")
class SecureEmbeddedTest extends SecureBrokerContract {
    @TempDir
    private static Path folder;

    private static EmbeddedBroker broker;
    private static int port;

    static boolean isInstalled() {
        return EmbeddedBroker.isInstalled();
    }

    @BeforeAll
    static void start() throws Exception {
        ListenKey.create(folder);
        port = Loopback.freePort();
        broker = EmbeddedBroker.start(new EmbeddedOptions(
                new InetSocketAddress("127.0.0.1", port),
                folder.resolve(ListenKey.FILE),
                ListenKey.PASSWORD,
                USER,
                PASSWORD));
    }

    @AfterAll
    static void stop() {
        broker.close();
    }

    @Override
    int port() {
        return port;
    }

    @Override
    Path certificate() {
        return folder.resolve(ListenKey.CERTIFICATE);
    }
}

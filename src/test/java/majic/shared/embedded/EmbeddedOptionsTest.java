package majic.shared.embedded;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import majic.bot.BotException;
import majic.link.Loopback;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Which embedded brokers are refused, and with which sentence. */
class EmbeddedOptionsTest {
    private static final InetSocketAddress EVERYWHERE = new InetSocketAddress("0.0.0.0", 8883);

    @TempDir
    private Path folder;

    @Test
    void aBrokerForOtherComputersNeedsTlsAndAPassword() {
        Path key = folder.resolve("key.p12");

        assertThatThrownBy(() -> new EmbeddedOptions(EVERYWHERE, null, "", "anna", "secret"))
                .isInstanceOf(BotException.class);
        assertThatThrownBy(() -> new EmbeddedOptions(EVERYWHERE, key, "", null, null))
                .hasMessageContaining("MAJIC_MQTT_PASSWORD");
        assertThatThrownBy(() -> new EmbeddedOptions(EVERYWHERE, key, "", "anna", ""))
                .hasMessageContaining("MAJIC_MQTT_PASSWORD");
        assertThat(new EmbeddedOptions(EVERYWHERE, key, "", "anna", "secret")).hasToString("mqtts://0.0.0.0:8883");
    }

    @Test
    void anAddressOfAnotherComputerIsRefused() {
        InetSocketAddress unknown = InetSocketAddress.createUnresolved("no-such-computer.invalid", 1883);

        assertThatThrownBy(() -> new EmbeddedOptions(unknown, null, "", null, null))
                .hasMessageContaining("not an address of this computer");
    }

    @Test
    void withoutItsLibrariesTheMessageSaysHowToGetThemOrAnotherBroker() {
        EmbeddedOptions options = EmbeddedOptions.loopback(Loopback.freePort());

        assertThatThrownBy(() -> EmbeddedBroker.start(folder.resolve("broker"), options))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("./majic --broker")
                .hasMessageContaining("Mosquitto");
    }

    @Test
    void aTakenPortIsNamed() throws IOException {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
            EmbeddedOptions options = EmbeddedOptions.loopback(taken.getLocalPort());

            assertThatThrownBy(() -> EmbeddedBroker.start(folder, options))
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("cannot listen at " + options);
        }
    }
}

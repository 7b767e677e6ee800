package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import majic.bot.BotException;
import majic.environment.FolderSettings;
import majic.environment.Settings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Where the user names and passwords of brokers come from. */
class BrokerCredentialsTest {
    private static final BrokerAddress BROKER = BrokerAddress.parse("mqtts://broker/lab");

    @TempDir
    private Path folder;

    private Settings settings() {
        return new FolderSettings(folder);
    }

    private void write(String permissions, String... lines) throws IOException {
        Path file = Files.writeString(folder.resolve("brokers.properties"), String.join("\n", lines));
        if (Files.getFileStore(file).supportsFileAttributeView("posix")) {
            Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
        }
    }

    private BrokerCredentials found(Map<String, String> environment) {
        return BrokerCredentials.find(BROKER, settings(), environment);
    }

    @Test
    void withoutFileAndEnvironmentThereAreNone() {
        assertThat(found(Map.of()).login()).isEmpty();
        assertThat(found(Map.of())).hasToString("no user");
    }

    @Test
    void theFileHasThemForEachBroker() throws IOException {
        write(
                "rw-------",
                "broker.broker.user=anna",
                "broker.broker.password=secret",
                "broker.broker.ca=lab.pem",
                "broker.broker.key-store=anna.p12",
                "broker.broker.key-store-password=other",
                "broker.elsewhere.user=bert");

        BrokerCredentials found = found(Map.of());

        assertThat(found)
                .isEqualTo(new BrokerCredentials(
                        "anna", "secret", folder.resolve("lab.pem"), folder.resolve("anna.p12"), "other"));
        assertThat(found.toString()).isEqualTo("user anna");
    }

    @Test
    void theEnvironmentOverridesTheUserAndThePasswordOfTheFile() throws IOException {
        write("rw-------", "broker.broker.user=anna", "broker.broker.password=secret");

        BrokerCredentials found = found(Map.of("MAJIC_MQTT_USER", "carla"));

        assertThat(found.user()).isEqualTo("carla");
        assertThat(found.password()).isNull();
    }

    @Test
    void whatTheUserTypesIsUsedForThisBrokerAlone() throws IOException {
        write("rw-------", "broker.broker.user=anna", "broker.broker.password=secret");
        BrokerAddress typed = BrokerAddress.parse("mqtts://broker:18883/lab");
        BrokerLogins.use(typed, "dora", "typed");

        assertThat(found(Map.of()).user()).isEqualTo("anna");
        assertThat(BrokerCredentials.find(typed, settings(), Map.of()).user()).isEqualTo("dora");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aFileThatOthersCanReadIsRefused() throws IOException {
        write("rw-r-----", "broker.broker.user=anna");

        assertThatThrownBy(() -> found(Map.of()))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("chmod 600")
                .hasMessageEndingWith("?")
                .hasMessageContaining("brokers.properties");
    }

    @Test
    void aDamagedFileIsRefusedWithAReason() throws IOException {
        write("rw-------", "broker.broker.user=\\uXYZ");

        assertThatThrownBy(() -> found(Map.of()))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("four hexadecimal digits");
    }
}

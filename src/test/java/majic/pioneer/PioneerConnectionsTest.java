package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PioneerConnectionsTest {
    private final Settings settings = Settings.inMemory();

    private void create(String address) {
        new PioneerType().create(BotAddress.parse(address), new BotEnvironment(TimeSource.system(), settings));
    }

    @Test
    void anotherLibraryIsRefusedWithTheRightAddresses() {
        assertThatThrownBy(() -> create("pioneer+urbi://10.0.0.5"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("there is no library urbi")
                .hasMessageContaining("pioneer://10.0.0.5 or pioneer+aria://10.0.0.5");
    }

    @Test
    void anInvalidAddressIsRefusedBeforeAriaIsLookedFor() {
        assertThatThrownBy(() -> create("pioneer+aria://10.0.0.5:x"))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("pioneer+aria://10.0.0.5:x: not an address");
    }

    @Test
    void anAriaThatIsNotInstalledIsReportedWithItsFolder(@TempDir Path folder) {
        settings.put("aria.home", folder.resolve("none").toString());

        assertThatThrownBy(() -> create("pioneer+aria:/dev/ttyS0"))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("ARIA is not found: there is no folder ");
    }

    @Test
    void theAddressOfAnotherTypeIsRefused() {
        assertThatThrownBy(() -> new MajicPioneer("hemisson:/dev/ttyS0"))
                .isInstanceOf(BotException.class)
                .hasMessage("hemisson:/dev/ttyS0: not a Pioneer's address; it looks like pioneer://10.0.0.5 or"
                        + " pioneer:/dev/ttyS0");
    }

    @Test
    void withoutALibraryNoneIsLookedFor() {
        settings.put("aria.home", "/nowhere");

        create("pioneer://10.0.0.5");

        assertThat(new PioneerType().libraries()).containsExactly("aria");
    }
}

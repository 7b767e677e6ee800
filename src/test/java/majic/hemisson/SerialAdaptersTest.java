package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import majic.bot.BotAddress;
import majic.bot.ConnectFailed;
import majic.bot.MajicBot.Connection;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.link.TestPorts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The driver at USB adapters that get each other's names. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no pseudo-terminals that are serial ports")
class SerialAdaptersTest {
    private static final String LEFTY = "A50285BI";
    private static final String RIGHTY = "A6004XYZ";

    @TempDir
    static Path folder;

    @AutoClose
    private final TestPorts ports = new TestPorts(folder);

    @AutoClose
    private final PortHemisson lefty = PortHemisson.stock();

    private final Settings settings = Settings.inMemory();
    private MajicHemisson bot;

    @BeforeEach
    void calibrateLefty() throws IOException {
        ports.plug(lefty.name(), "ttyUSB0", LEFTY);
        bot = connected("ttyUSB0", lefty);
        bot.set("wheelDistance", 77);
    }

    @AfterEach
    void close() {
        bot.close();
    }

    private MajicHemisson connected(String device, PortHemisson robot) {
        MajicHemisson driver = new MajicHemisson(
                new BotAddress("hemisson", ports.device(device)), new BotEnvironment(robot.time(), settings));
        driver.connect();
        return driver;
    }

    @Test
    void theCalibrationIsFoundUnderAnotherNameOfTheAdapter() throws IOException {
        bot.close();
        ports.unplugAll();
        try (PortHemisson back = PortHemisson.stock()) {
            ports.plug(back.name(), "ttyUSB1", LEFTY);
            try (MajicHemisson again = connected("ttyUSB1", back)) {
                assertThat(again.get("wheelDistance")).hasToString("77 mm");
            }
        }
    }

    @Test
    void anotherAdapterUnderTheNameHasItsOwnCalibration() throws IOException {
        bot.close();
        ports.unplugAll();
        try (PortHemisson righty = PortHemisson.stock()) {
            ports.plug(righty.name(), "ttyUSB0", RIGHTY);
            try (MajicHemisson other = connected("ttyUSB0", righty)) {
                assertThat(other.get("wheelDistance").number()).isNotEqualTo(77);
            }
        }
    }

    @Test
    void aCalibrationThatWasKeptUnderTheNameIsTakenOverOnce() throws IOException {
        bot.close();
        ports.unplugAll();
        String old = "hemisson." + ports.device("ttyUSB7") + ".";
        settings.put(old + "speedTable", "10 20 30 40 50 60 70 80 90");
        settings.put(old + "wheelDistance", "66");
        try (PortHemisson righty = PortHemisson.stock();
                PortHemisson third = PortHemisson.stock()) {
            ports.plug(righty.name(), "ttyUSB7", RIGHTY);
            try (MajicHemisson first = connected("ttyUSB7", righty)) {
                assertThat(first.get("wheelDistance")).hasToString("66 mm");
            }
            ports.unplugAll();
            ports.plug(third.name(), "ttyUSB7", "A7THIRD1");
            try (MajicHemisson second = connected("ttyUSB7", third)) {
                assertThat(second.get("wheelDistance").number()).isNotEqualTo(66);
            }
        }
    }

    @Test
    void aLostRobotIsNotConnectedToAnotherAdapterThatHasItsNameNow() throws IOException {
        lose();
        ports.unplugAll();
        try (PortHemisson righty = PortHemisson.stock()) {
            ports.plug(righty.name(), "ttyUSB0", RIGHTY);

            assertThatThrownBy(bot::connect)
                    .isInstanceOfSatisfying(
                            ConnectFailed.class,
                            failed -> assertThat(failed.reason()).isEqualTo(ConnectFailed.Reason.OTHER_ADAPTER))
                    .hasMessageContaining("is another one now");
            assertThat(righty.heard()).isEmpty();
        }
    }

    private void lose() {
        lefty.close();
        while (bot.connection() != Connection.LOST) {
            Thread.onSpinWait();
        }
    }
}

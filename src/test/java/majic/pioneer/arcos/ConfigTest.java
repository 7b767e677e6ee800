package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ConfigTest {
    /** What firmware newer than the vendor's simulator sends behind field 57. */
    private static final String NEWEST = "03 2C 01 55 01 80 02 14 00 0A 00 62 31 2E 32 00 04 03 02 81 FE FF";

    @Test
    void theVendorsSimulatorDescribesItself() {
        Config config = Config.decode(Bytes.packet(Bytes.CONFIG));

        assertThat(config.text(ConfigField.SUBCLASS)).isEqualTo("p3dx");
        assertThat(config.text(ConfigField.SERNUM)).isEqualTo("SIM");
        assertThat(config.text(ConfigField.NAME)).isEqualTo("AMRISim");
        assertThat(config.speedTopMmPerSec()).isEqualTo(9999);
        assertThat(config.number(ConfigField.PWMMAX)).isEqualTo(400);
        assertThat(config.number(ConfigField.SIPCYCLE)).isEqualTo(100);
        assertThat(config.mayHave(ConfigField.FRONTSONAR)).isTrue();
        assertThat(config.mayHave(ConfigField.REARSONAR)).isTrue();
        assertThat(config.number(ConfigField.WATCHDOG)).isEqualTo(2000);
    }

    @Test
    void theVendorsSimulatorReportsItsSettings() {
        Config config = Config.decode(Bytes.packet(Bytes.CONFIG));

        assertThat(config.turnMaxDegPerSec()).isEqualTo(150);
        assertThat(config.speedMaxMmPerSec()).isEqualTo(3000);
        assertThat(config.number(ConfigField.ROTDECEL)).isEqualTo(100);
        assertThat(config.number(ConfigField.TRANSDECEL)).isEqualTo(300);
        assertThat(config.frontBumpers()).isZero();
        assertThat(config.autobaud()).isEqualTo(2);
        assertThat(config.text(ConfigField.FIRMWARE)).isEqualTo("S.0");
        assertThat(config.number(ConfigField.LATVELTOP)).isEqualTo(9999);
        assertThat(config.number(ConfigField.LATACCTOP)).isEqualTo(9999);
        assertThat(config.number(ConfigField.CHARGETHRESHOLD)).isZero();
        assertThat(config.number(ConfigField.HIGHTEMP)).isEqualTo(-128);
    }

    @Test
    void theNewestFirmwareReportsMore() {
        Config config = decode(concat(Bytes.packet(Bytes.CONFIG).data(), Bytes.of(NEWEST)));

        assertThat(config.number(ConfigField.PDBPORT)).isEqualTo(3);
        assertThat(config.number(ConfigField.GYRORATELIMIT)).isEqualTo(300);
        assertThat(config.number(ConfigField.HIGHTEMP)).isEqualTo(0x55);
        assertThat(config.number(ConfigField.POWERBITS)).isEqualTo(0x8001);
        assertThat(config.number(ConfigField.BATTERYTYPE)).isEqualTo(2);
        assertThat(config.number(ConfigField.LOWCHARGE)).isEqualTo(20);
        assertThat(config.number(ConfigField.SHUTDOWNCHARGE)).isEqualTo(10);
        assertThat(config.text(ConfigField.BOOTLOADER)).isEqualTo("b1.2");
        assertThat(config.number(ConfigField.CONFIGFLAGS)).isEqualTo(0x81020304L);
        assertThat(config.number(ConfigField.GYROFIRMWARE)).isEqualTo(-2);
    }

    @Test
    void fieldsBehindTheEndOfAPacketAreZero() {
        byte[] whole = Bytes.packet(Bytes.CONFIG).data();
        for (int length = 0; length <= whole.length; length++) {
            Config config = decode(Arrays.copyOf(whole, length));
            assertThat(config.number(ConfigField.WATCHDOG)).isIn(0L, 2000L);
            assertThat(config.speedMaxMmPerSec()).isIn(0, 3000);
            assertThat("S.0").startsWith(config.text(ConfigField.FIRMWARE));
        }
    }

    @Test
    void aPacketThatStopsAfterTheGainsIsEnough() {
        Config config = decode(Arrays.copyOf(Bytes.packet(Bytes.CONFIG).data(), 83));

        assertThat(config.number(ConfigField.TRANSDECEL)).isEqualTo(300);
        assertThat(config.frontBumpers()).isZero();
        assertThat(config.text(ConfigField.FIRMWARE)).isEmpty();
    }

    @Test
    void textIsNoNumberAndNumbersAreNoText() {
        Config config = decode(new byte[0]);

        assertThatIllegalArgumentException().isThrownBy(() -> config.number(ConfigField.NAME));
        assertThatIllegalArgumentException().isThrownBy(() -> config.text(ConfigField.WATCHDOG));
    }

    private static Config decode(byte[] data) {
        return Config.decode(new Packet(Config.TYPE, data, 0, data.length));
    }

    private static byte[] concat(byte[] some, byte[] more) {
        byte[] all = Arrays.copyOf(some, some.length + more.length);
        System.arraycopy(more, 0, all, some.length, more.length);
        return all;
    }
}

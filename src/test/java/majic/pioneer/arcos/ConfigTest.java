package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ConfigTest {

    @Test
    void theVendorsSimulatorDescribesItself() {
        Config config = Config.decode(Bytes.packet(Bytes.CONFIG));

        assertThat(config.subclass()).isEqualTo("p3dx");
        assertThat(config.serialNumber()).isEqualTo("SIM");
        assertThat(config.speedTopMmPerSec()).isEqualTo(9999);
        assertThat(config.name()).isEqualTo("AMRISim");
        assertThat(config.cycleMs()).isEqualTo(100);
        assertThat(config.hasFrontSonar()).isTrue();
        assertThat(config.hasRearSonar()).isTrue();
        assertThat(config.watchdogMs()).isEqualTo(2000);
        assertThat(config.turnMaxDegPerSec()).isEqualTo(150);
        assertThat(config.speedMaxMmPerSec()).isEqualTo(3000);
        assertThat(config.frontBumpers()).isZero();
        assertThat(config.autobaud()).isEqualTo(2);
        assertThat(config.version()).isEqualTo("S.0");
    }

    @Test
    void whatDoesNotComeIsZeroOrEmpty() {
        byte[] data = Bytes.of("50 00 70 33 64 78 00 31 00 00 0F");

        Config config = Config.decode(new Packet(Config.TYPE, data, 0, data.length));

        assertThat(config.subclass()).isEqualTo("p3dx");
        assertThat(config.speedTopMmPerSec()).isZero();
        assertThat(config.version()).isEmpty();
    }
}

package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import majicsim.pioneer.devices.Compass;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.report.EncoderReport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** How far SIP and CONFIG of each generation go, and what stands in them (ARCOS sheet 8, 10). */
class FirmwareGenerationTest {
    @ParameterizedTest
    @CsvSource({"p2dx, 36, 5", "p3dx, 57, 16", "p3dx-sh, 67, 24", "seekur, 67, 24"})
    void packetsOnlyEverGrewAtTheirEnds(String model, int configFields, int tailBytes) {
        Rig rig = Rig.open(model);
        assertThat(rig.config().fieldCount()).isEqualTo(configFields);
        assertThat(rig.nextSip().tailLength()).isEqualTo(tailBytes);
    }

    @Test
    void theNewestReportsAllItsFields() {
        ConfigView config = Rig.open(Rig.EQUIPPED).command(48, 50).config();
        assertThat(config.numbers()).containsAllEntriesOf(Map.of("GRIPPER", 1, "FRONTSONAR", 1, "REARSONAR", 1));
        assertThat(config.numbers()).containsAllEntriesOf(Map.of("LOWBATTERY", 115, "TICKSMM", 128, "SONARCYCLE", 50));
        assertThat(config.numbers()).containsAllEntriesOf(Map.of("CHARGER", 1, "HASGYRO", 1, "AUTOBAUD", 2));
        assertThat(config.numbers()).containsAllEntriesOf(Map.of("JOYVEL", 600, "JOYRVEL", 60, "HIGHTEMP", 75));
        assertThat(config.texts()).containsEntry("SERNUM", "SIM").containsEntry("BOOTLOADER", "S.0");
    }

    @ParameterizedTest
    @MethodSource("majicsim.pioneer.PioneerRobot#models")
    void everyModelsConfigReportsItsOwnSubclassAndSonar(String model) {
        ConfigView config = Rig.open(model).config();
        assertThat(config.texts()).containsEntry("SUBCLASS", model);
        boolean anyDisc = !PioneerModel.of(model).sonars().isEmpty();
        assertThat(config.number("FRONTSONAR") | config.number("REARSONAR")).isEqualTo(anyDisc ? 1 : 0);
    }

    @Test
    void heatShowsAndRaisesTheWarning() {
        Rig rig = Rig.open();
        assertThat(rig.nextSip().celsius()).isEqualTo(25);
        assertThat(rig.nextSip().faults()).isZero();
        rig.robot.handling().heat(65);
        assertThat(rig.nextSip().celsius()).isEqualTo(65);
        assertThat(rig.nextSip().faults()).isEqualTo(0b10);
    }

    @Test
    void anOlderOneReportsNeitherTemperatureNorCharge() {
        SipView sip = Rig.open("p3dx").nextSip();
        assertThat(sip.celsius()).isEqualTo(-127);
        assertThat(sip.chargePercent()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0, 45", "90, 180", "180, 135", "-90, 90", "89.5, 180", "87, 2"})
    void theCompassCountsClockwiseFromTheRoomsYAxis(double headingDeg, int units) {
        assertThat(new Compass().reading(headingDeg)).isEqualTo(units);
    }

    @Test
    void tcm2SwitchesTheCompassOff() {
        Rig rig = Rig.open("p3at-sh");
        assertThat(rig.nextSip().compass()).isEqualTo(45);
        assertThat(rig.command(45, 0).nextSip().compass()).isZero();
    }

    @Test
    void encodersRollOver() {
        double almostFullMm = Integer.MAX_VALUE / (double) EncoderReport.TICKS_PER_MM;
        byte[] packet = new EncoderReport(almostFullMm + 1, 1000).toBytes();
        assertThat(packet).startsWith(0xFA, 0xFB, 0x0B, 0x90, 0x7F, 0, 0, 0x80, 0x00, 0xF4, 0x01, 0x00);
    }

    @Test
    void encodersCountEachWheel() {
        Rig rig = Rig.ready().command(8, 500).pulse(4);
        byte[] packet = rig.command(19, 1).packets(0x90, 0.1).get(0);
        assertThat(packet).startsWith(0xFA, 0xFB, 0x0B, 0x90, 0x00, 0xFA, 0, 0, 0x00, 0xFA, 0, 0);
    }

    @Test
    void theMovingSipHasItsOwnType() {
        Rig rig = Rig.ready();
        assertThat(rig.nextSip().type()).isEqualTo(0x32);
        assertThat(rig.command(11, 100).pulse(1).nextSip().type()).isEqualTo(0x33);
        assertThat(rig.command(11, 0).pulse(1).nextSip().type()).isEqualTo(0x32);
    }
}

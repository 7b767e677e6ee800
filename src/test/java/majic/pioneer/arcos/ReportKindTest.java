package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportKindTest {

    @Test
    void encodersCountBothWays() {
        assertThat(ReportKind.decode(Bytes.packet("FA FB 0B 90 00 F4 01 00 00 06 FF FF 8B FF")))
                .isEqualTo(new Encoders(128_000, -64_000));
    }

    @Test
    void portsAreAsManyAsReported() {
        InputsOutputs ports = (InputsOutputs)
                ReportKind.decode(Bytes.packet("FA FB 0F F0 04 FF FF FF FF 01 00 02 00 02 BC 02 F5 BC"));

        assertThat(ports).isNotNull();
        assertThat(ports.digitalIn()).containsExactly(255, 255, 255, 255);
        assertThat(ports.digitalOut()).containsExactly(0);
        assertThat(ports.analog()).containsExactly(512, 700);
    }

    @Test
    void everyBatteryHasItsOwnCharge() {
        assertThat(decode(0xFA, "02 06 01 02 03 50 46 AA 04 05 06 28 1E BB"))
                .isEqualTo(new Batteries(
                        List.of(new Batteries.Cell(1, 2, 3, 80, 70), new Batteries.Cell(4, 5, 6, 40, 30))));
    }

    @Test
    void aBatteryOfFewBytesHasZerosForTheRest() {
        assertThat(decode(0xFA, "01 02 01 02")).isEqualTo(new Batteries(List.of(new Batteries.Cell(1, 2, 0, 0, 0))));
    }

    @Test
    void aJoystickHasTwoButtonsAndThreeAxes() {
        assertThat(decode(0xF8, "01 00 00 02 FF 03 0A 00")).isEqualTo(new Joystick(true, false, 512, 1023, 10));
    }

    @Test
    void aGripperHasAKindSwitchesAndAGraspTime() {
        assertThat(decode(0xE0, "02 11 0A")).isEqualTo(new GripperReport(2, 0x11, 10));
    }

    @Test
    void aGyroSendsItsSamplesTogether() {
        Gyro gyro = (Gyro) decode(0x98, "02 00 02 19 0A 02 1A");

        assertThat(gyro).isNotNull();
        assertThat(gyro.samples()).containsExactly(new Gyro.Sample(512, 25), new Gyro.Sample(522, 26));
    }

    @ParameterizedTest
    @ValueSource(ints = {0x62, 0x60, 0x00, 0x99, 0xB0, 0xC0, 0xFF})
    void othersAreNoReports(int type) {
        assertThat(decode(type, "01 02 03 04 05 06 07 08")).isNull();
    }

    @ParameterizedTest
    @ValueSource(ints = {0x90, 0x98, 0xE0, 0xF0, 0xF8, 0xFA})
    void countsBeyondTheEndOfThePacketReadOnlyWhatIsThere(int type) {
        byte[] full = new byte[12];
        Arrays.fill(full, (byte) 0xFF);
        for (int length = 0; length <= full.length; length++) {
            Packet packet = new Packet(type, full, 0, length);
            assertThat(String.valueOf(ReportKind.decode(packet))).hasSizeLessThan(300);
        }
    }

    private static @Nullable Report decode(int type, String data) {
        byte[] bytes = Bytes.of(data);
        return ReportKind.decode(new Packet(type, bytes, 0, bytes.length));
    }
}

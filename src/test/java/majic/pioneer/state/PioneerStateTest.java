package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Objects;
import majic.bot.Pose;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Joystick;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PioneerStateTest {
    /**
     * Gripper open and lift down, analog port 3 at half, DIGIN, DIGOUT, 12.8 V, bulk, −15 deg/s, a fault, 31 °C, 74 %.
     */
    private static final String TAIL = "21 03 80 F0 0F 80 00 01 6A FF 02 00 00 00 1F 4A";

    private final StateTracker tracker = new StateTracker(Models.of("p3dx-sh"), Pose.START);

    @Test
    void theTailOfASipHasBatteryAndCharger() {
        Power power = track(new SipBytes().state(0, 1 << 10).tail(TAIL)).power();

        assertThat(power.volts()).isEqualTo(12.8);
        assertThat(power.percent()).hasValue(74);
        assertThat(power.charging()).isEqualTo(Charging.BULK);
        assertThat(power.chargerConnected()).isTrue();
    }

    @Test
    void theTailOfASipHasPortsAndEquipment() {
        PioneerState state = track(new SipBytes().compass(45).tail(TAIL));

        assertThat(state.ports().digitalIn()).hasValue(0xF0);
        assertThat(state.ports().digitalOut()).hasValue(0x0F);
        assertThat(state.ports().analogPort()).hasValue(3);
        assertThat(state.ports().analogVolts().orElseThrow()).isCloseTo(2.5, within(0.02));
        assertThat(state.gripper()).hasValue(new Gripper(true, false, false, false, true, false));
        assertThat(state.compassDeg()).hasValue(90);
        assertThat(state.temperatureC()).hasValue(31);
        assertThat(state.faults()).hasValue(2);
    }

    @Test
    void withoutATailNothingIsMadeUp() {
        PioneerState state = track(new SipBytes());

        assertThat(state.power().volts()).isEqualTo(12.5);
        assertThat(state.power().percent()).isEmpty();
        assertThat(state.power().charging()).isEqualTo(Charging.UNKNOWN);
        assertThat(state.ports().digitalIn()).isEmpty();
        assertThat(state.ports().analogVolts()).isEmpty();
        assertThat(state.gripper()).isEmpty();
        assertThat(state.compassDeg()).isEmpty();
        assertThat(state.temperatureC()).isEmpty();
        assertThat(state.faults()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0, NONE", "1, BULK", "2, OVERCHARGE", "3, FLOAT", "4, BALANCE", "5, UNKNOWN", "255, UNKNOWN"})
    void everyChargeStateHasItsMeaning(int code, Charging meaning) {
        String tail = "00 00 00 FF FF 82 00 " + "%02X".formatted(code);

        assertThat(track(new SipBytes().tail(tail)).power().charging()).isEqualTo(meaning);
    }

    @ParameterizedTest
    @CsvSource({"80", "81"})
    void thermometersThatAreNotThereShowNothing(String none) {
        String tail = "00 00 00 FF FF 82 00 00 00 00 00 00 00 00 " + none;

        assertThat(track(new SipBytes().tail(tail)).temperatureC()).isEmpty();
    }

    @Test
    void flagsShowButtonsAndLedges() {
        PioneerState state = track(new SipBytes().state(0, 0b11_1110_0000));

        assertThat(state.stopButton()).isTrue();
        assertThat(state.stopEngaged()).isTrue();
        assertThat(state.ledge()).isTrue();
        assertThat(state.motorsOn()).isFalse();
        assertThat(state.power().chargerConnected()).isFalse();
    }

    @Test
    void encodersGoOnWhereTheRobotsOwnRollOver() {
        receive("90", "F6 FF FF 7F 0A 00 00 80");
        PioneerState state = receive("90", "0A 00 00 80 F6 FF FF 7F");

        assertThat(state.encoders()).hasValue(new EncoderTicks(Integer.MAX_VALUE + 11L, Integer.MIN_VALUE - 10L));
    }

    @Test
    void packetsBesideTheSipsStayUntilTheNextOfTheirKind() {
        receive("F8", "01 00 00 02 00 02 00 00");
        receive("90", "01 00 00 00 02 00 00 00");
        PioneerState state = receive("F8", "00 00 00 02 00 02 00 00");

        assertThat(state.joystick()).hasValue(new Joystick(false, false, 512, 512, 0));
        assertThat(state.encoders()).hasValue(new EncoderTicks(1, 2));
    }

    @Test
    void theIoPacketHasAllPorts() {
        PioneerState state = receive("F0", "02 FF FE 01 00 02 00 02 FF 03");

        assertThat(state.ports().allDigitalIn()).containsExactly(255, 254);
        assertThat(state.ports().allAnalogVolts()).hasSize(2);
        assertThat(state.ports().allAnalogVolts().get(1)).isEqualTo(5);
    }

    @Test
    void batteriesWithElectronicsReportTheCharge() {
        assertThat(receive("FA", "02 05 00 00 00 50 46 00 00 00 28 1E").power().percent())
                .hasValue(60);
    }

    @Test
    void aChargeOfMoreThanAllIsNotKnown() {
        assertThat(receive("FA", "01 05 00 00 00 FA 00").power().percent()).isEmpty();
    }

    @Test
    void theGyroTurnsLeftBelowItsRest() {
        assertThat(receive("98", "02 F6 01 19 F6 01 19").gyroDegPerSec().orElseThrow())
                .isCloseTo(9.54, within(0.01));
        assertThat(receive("98", "00").gyroDegPerSec()).isEmpty();
    }

    private PioneerState track(SipBytes sip) {
        return tracker.track(sip.sip(), 1);
    }

    private PioneerState receive(String type, String data) {
        byte[] bytes = Bytes.of(data);
        Packet packet = new Packet(Integer.parseInt(type, 16), bytes, 0, bytes.length);
        tracker.add(Objects.requireNonNull(ReportKind.decode(packet)));
        return tracker.track(new SipBytes().sip(), 1);
    }
}

package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SipTest {
    /** All fields that the newest firmware sends after the readings. */
    private static final String LONGEST_TAIL =
            "21 03 80 F0 0F 1C 01 01 6A FF 02 00 F6 FF E2 4A 01 02 03 84 05 06 07 88";

    private static final Set<SipField> TAIL = EnumSet.range(SipField.GRIP_STATE, SipField.FLAGS3);

    @Test
    void aRobotAtRestReportsZeroVelocities() {
        Sip sip = Bytes.sip(Bytes.AT_REST);

        assertThat(sip.get(SipField.FLAGS)).isEqualTo(0x1F);
        assertThat(sip.get(SipField.BATTERY)).isEqualTo(130);
        assertThat(sip.readings()).isEqualTo(16);
        assertThat(sip.disc(2)).isEqualTo(2);
        assertThat(sip.range(2)).isEqualTo(4447);
        assertThat(sip.range(12)).isEqualTo(1752);
        assertThat(sip.get(SipField.DIG_IN)).isEqualTo(0xFF);
        assertThat(sip.get(SipField.BATTERY_TENTHS)).isEqualTo(130);
        assertThat(sip.get(SipField.TEMPERATURE)).isEqualTo(-127);
        assertThat(sip.get(SipField.CHARGE_PERCENT)).isZero();
        assertThat(sip.has(SipField.FLAGS3)).isFalse();
    }

    @Test
    void aMovingRobotReportsPoseAndVelocities() {
        Sip sip = Bytes.sip(Bytes.TURNING_RIGHT);

        assertThat(sip.get(SipField.X_POS)).isEqualTo(519);
        assertThat((short) sip.get(SipField.Y_POS)).isEqualTo((short) -107);
        assertThat(sip.get(SipField.TH_POS)).isEqualTo(-238);
        assertThat(sip.get(SipField.L_VEL)).isEqualTo(296);
        assertThat(sip.get(SipField.R_VEL)).isEqualTo(203);
        assertThat(sip.get(SipField.TURN_RATE_TENTHS)).isEqualTo(-150);
    }

    @Test
    void bothMotorsOfAStalledRobotShow() {
        Sip sip = Bytes.sip(Bytes.STALLED);

        assertThat(sip.get(SipField.STALL_REAR)).isEqualTo(1);
        assertThat(sip.get(SipField.STALL_FRONT)).isEqualTo(1);
        assertThat(sip.range(3)).isEqualTo(100);
    }

    @Test
    void theNewestFirmwareSendsAllFieldsOfTheTail() {
        Sip sip = new SipBytes().sonar(3, 1000).tail(LONGEST_TAIL).sip();

        assertThat(TAIL.stream().map(sip::number))
                .containsExactly(
                        0x21L, 3L, 0x80L, 0xF0L, 0x0FL, 284L, 1L, -150L, 2L, -10L, -30L, 74L, 0x84030201L, 0x88070605L);
    }

    @Test
    void aLineOfTextHoldsAllOfASip() {
        Sip sip = new SipBytes()
                .sonar(3, 1000)
                .sonar(7, 60_000)
                .tail(LONGEST_TAIL)
                .sip();
        Sip older = Bytes.sip(Bytes.AT_REST);

        assertThat(Sip.parse(sip.text())).isEqualTo(sip);
        assertThat(Sip.parse(older.text())).isEqualTo(older);
    }

    @Test
    void aTextWithTooFewFieldsIsRefused() {
        assertThatThrownBy(() -> Sip.parse("50 1 2 3")).hasMessage("the SIP is too short");
    }

    @Test
    void aShortTailLacksPartialFields() {
        byte[] whole = new SipBytes().sonar(3, 1000).tail(LONGEST_TAIL).bytes();
        for (int length = 22; length <= whole.length; length++) {
            Sip sip = Sip.decode(new Packet(0x33, whole, 0, length));

            assertThat(sip).isNotNull();
            assertThat(sip.range(0)).isEqualTo(1000);
            assertThat(sip.get(SipField.BATTERY_TENTHS)).isEqualTo(length < 22 + 7 ? Sip.ABSENT : 284);
            assertThat(sip.get(SipField.TURN_RATE_TENTHS)).isEqualTo(length < 22 + 10 ? Sip.ABSENT : -150);
            assertThat(sip.get(SipField.TEMPERATURE)).isEqualTo(length < 22 + 15 ? Sip.ABSENT : -30);
            assertThat(sip.number(SipField.CLOCK_MICROS)).isEqualTo(length < 22 + 20 ? Sip.ABSENT : 0x84030201L);
        }
    }

    @Test
    void whatIsLongerThanKnownIsIgnored() {
        Sip known = new SipBytes().tail(LONGEST_TAIL).sip();

        assertThat(new SipBytes().tail(LONGEST_TAIL + "01 02 03").sip()).isEqualTo(known);
    }

    @Test
    void aCountWithoutReadingsBehindItIsNoReading() {
        byte[] data = Arrays.copyOf(data(Bytes.AT_REST), 19 + 17);
        Sip sip = Sip.decode(new Packet(0x32, data, 0, data.length));

        assertThat(sip).isNotNull();
        assertThat(sip.readings()).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 10, 18})
    void aPacketTooShortIsNoSip(int length) {
        byte[] data = Arrays.copyOf(data(Bytes.AT_REST), length);

        assertThat(Sip.decode(new Packet(0x32, data, 0, length))).isNull();
    }

    private static byte[] data(String hex) {
        byte[] packet = Bytes.of(hex);
        return Arrays.copyOfRange(packet, 4, packet.length - 2);
    }
}

package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SipTest {
    /** All fields that the newest firmware sends after the readings. */
    private static final String LONGEST_TAIL =
            "21 03 80 F0 0F 1C 01 01 6A FF 02 00 F6 FF E2 4A 01 02 03 84 05 06 07 88";

    @Test
    void aRobotAtRestReportsZeroVelocities() {
        Sip sip = Bytes.sip(Bytes.AT_REST);

        assertThat(sip.flags()).isEqualTo(0x1F);
        assertThat(sip.battery()).isEqualTo(130);
        assertThat(sip.sonar().count()).isEqualTo(16);
        assertThat(sip.sonar().disc(2)).isEqualTo(2);
        assertThat(sip.sonar().range(2)).isEqualTo(4447);
        assertThat(sip.sonar().range(12)).isEqualTo(1752);
        assertThat(sip.tail().digIn()).isEqualTo(0xFF);
        assertThat(sip.tail().batteryTenths()).isEqualTo(130);
        assertThat(sip.tail().temperature()).isEqualTo(-127);
        assertThat(sip.tail().chargePercent()).isZero();
        assertThat(sip.tail().flags3()).isEqualTo(SipTail.ABSENT);
    }

    @Test
    void aMovingRobotReportsPoseAndVelocities() {
        Sip sip = Bytes.sip(Bytes.TURNING_RIGHT);

        assertThat(sip.xPos()).isEqualTo(519);
        assertThat((short) sip.yPos()).isEqualTo((short) -107);
        assertThat(sip.thPos()).isEqualTo(-238);
        assertThat(sip.lVel()).isEqualTo(296);
        assertThat(sip.rVel()).isEqualTo(203);
        assertThat(sip.tail().turnRateTenths()).isEqualTo(-150);
    }

    @Test
    void bothMotorsOfAStalledRobotShow() {
        Sip sip = Bytes.sip(Bytes.STALLED);

        assertThat(sip.stallRear()).isEqualTo(1);
        assertThat(sip.stallFront()).isEqualTo(1);
        assertThat(sip.sonar().range(3)).isEqualTo(100);
    }

    @Test
    void theNewestFirmwareSendsAllFieldsOfTheTail() {
        SipTail tail = new SipBytes().sonar(3, 1000).tail(LONGEST_TAIL).sip().tail();

        assertThat(tail)
                .isEqualTo(new SipTail(
                        0x21, 3, 0x80, 0xF0, 0x0F, 284, 1, -150, 2, -10, -30, 74, 0x84030201L, 0x88070605L));
    }

    @Test
    void aShortTailLacksPartialFields() {
        byte[] whole = new SipBytes().sonar(3, 1000).tail(LONGEST_TAIL).bytes();
        for (int length = 22; length <= whole.length; length++) {
            Sip sip = Sip.decode(new Packet(0x33, whole, 0, length));

            assertThat(sip).isNotNull();
            assertThat(sip.sonar().range(0)).isEqualTo(1000);
            assertThat(sip.tail().batteryTenths()).isEqualTo(length < 22 + 7 ? SipTail.ABSENT : 284);
            assertThat(sip.tail().turnRateTenths()).isEqualTo(length < 22 + 10 ? SipTail.ABSENT : -150);
            assertThat(sip.tail().temperature()).isEqualTo(length < 22 + 15 ? SipTail.ABSENT : -30);
            assertThat(sip.tail().clockMicros()).isEqualTo(length < 22 + 20 ? SipTail.ABSENT : 0x84030201L);
        }
    }

    @Test
    void whatIsLongerThanKnownIsIgnored() {
        Sip known = new SipBytes().tail(LONGEST_TAIL).sip();

        assertThat(new SipBytes().tail(LONGEST_TAIL + "01 02 03").sip().tail()).isEqualTo(known.tail());
    }

    @Test
    void aCountWithoutReadingsBehindItIsNoReading() {
        byte[] data = Arrays.copyOf(data(Bytes.AT_REST), 19 + 17);
        Sip sip = Sip.decode(new Packet(0x32, data, 0, data.length));

        assertThat(sip).isNotNull();
        assertThat(sip.sonar().count()).isZero();
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

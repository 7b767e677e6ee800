package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SipTest {
    private static final Scaling P3DX = Models.of("p3dx").scaling();

    @Test
    void aRobotAtRestSaysSo() {
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
    void aMovingRobotIsScaledByItsModel() {
        Sip sip = Bytes.sip(Bytes.TURNING_RIGHT);

        assertThat(sip.xPos() * P3DX.mmPerCount()).isCloseTo(251.7, within(0.1));
        assertThat(sip.thPos() * Scaling.DEG_PER_UNIT).isCloseTo(-20.9, within(0.1));
        assertThat(P3DX.speedMmPerSec(sip)).isEqualTo(249.5);
        assertThat(P3DX.turnRateDegPerSec(sip)).isEqualTo(-15.0);
    }

    @Test
    void bothMotorsOfAStalledRobotShow() {
        Sip sip = Bytes.sip(Bytes.STALLED);

        assertThat(sip.stallRear()).isEqualTo(1);
        assertThat(sip.stallFront()).isEqualTo(1);
        assertThat(sip.sonar().range(3)).isEqualTo(100);
    }

    @Test
    void withoutATurnRateTheWheelsTellIt() {
        Sip sip = Bytes.sip(cut(Bytes.TURNING_RIGHT, 19 + 16 * 3));

        assertThat(sip.tail().turnRateTenths()).isEqualTo(SipTail.ABSENT);
        assertThat(P3DX.turnRateDegPerSec(sip)).isCloseTo(-14.9, within(0.1));
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

    private static String cut(String hex, int length) {
        byte[] data = Arrays.copyOf(data(hex), length);
        return Bytes.hex(Peer.packet(0x32, data));
    }
}

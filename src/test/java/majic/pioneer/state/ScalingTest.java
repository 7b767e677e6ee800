package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Objects;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipField;
import org.junit.jupiter.api.Test;

class ScalingTest {
    private static final Scaling P3DX = Models.of("p3dx").scaling();

    @Test
    void aMovingRobotIsScaledByItsModel() {
        Sip sip = Bytes.sip(Bytes.TURNING_RIGHT);

        assertThat(sip.get(SipField.X_POS) * P3DX.mmPerCount()).isCloseTo(251.7, within(0.1));
        assertThat(sip.get(SipField.TH_POS) * Scaling.DEG_PER_UNIT).isCloseTo(-20.9, within(0.1));
        assertThat(P3DX.speedMmPerSec(sip)).isEqualTo(249.5);
        assertThat(P3DX.turnRateDegPerSec(sip)).isEqualTo(-15.0);
    }

    @Test
    void withoutATurnRateItIsComputedFromTheWheels() {
        byte[] upToSonar = Arrays.copyOf(Bytes.packet(Bytes.TURNING_RIGHT).data(), 19 + 16 * 3);
        Sip sip = Objects.requireNonNull(Sip.decode(new Packet(0x32, upToSonar, 0, upToSonar.length)));

        assertThat(P3DX.turnRateDegPerSec(sip)).isCloseTo(-14.9, within(0.1));
    }
}

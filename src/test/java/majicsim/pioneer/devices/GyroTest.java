package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import majicsim.pioneer.Rig;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

/** GYRO and its packets (ARCOS sheet 11.6). */
class GyroTest {
    private static final int GYRO = 58;
    private static final int RVEL = 21;

    @Test
    void atRestEverySampleIs512() {
        Rig rig = Rig.ready(Rig.EQUIPPED).command(GYRO, 1);
        assertThat(rates(rig)).containsExactly(512, 512, 512, 512);
        assertThat(rig.packets(0x98, 0.1).get(0)[7]).isEqualTo((byte) 25);
    }

    @Test
    void turningAsFastAsTheScaleShowsInEverySample() {
        Rig rig = Rig.ready(Rig.EQUIPPED).command(GYRO, 1).command(RVEL, 65).pulse(2);
        assertThat(rates(rig)).containsOnly(512 + 40);
        assertThat(rates(rig.command(RVEL, -65).pulse(4))).containsOnly(512 - 40);
    }

    @Test
    void packetsComeWithEverySipUntilSwitchedOff() {
        Rig rig = Rig.open(Rig.EQUIPPED).command(GYRO, 1);
        assertThat(rig.packets(0x98, 1)).hasSize(10);
        assertThat(rig.command(GYRO, 0).packets(0x98, 1)).isEmpty();
    }

    @Test
    void aNoisyOneTremblesAndItsRestValueWanders() {
        Rig rig = new Rig(new Pose(0, 0, 0), Noise.seeded(7), Rig.EQUIPPED).shakeHands();
        double early = meanOver(rig, 30);
        rig.pulse(600);
        assertThat(rates(rig.command(GYRO, 1))).hasSize(4);
        assertThat(meanOver(rig, 30)).isNotEqualTo(early).isBetween(511.0, 513.0);
    }

    @Test
    void aRobotWithoutGyroSendsNone() {
        Rig rig = Rig.open().command(GYRO, 1);
        assertThat(rig.packets(0x98, 0.5)).isEmpty();
        assertThat(rig.config().number("HASGYRO")).isZero();
    }

    private static double meanOver(Rig rig, double seconds) {
        return rig.command(GYRO, 1).packets(0x98, seconds).stream()
                .flatMapToInt(packet -> Arrays.stream(rates(packet)))
                .average()
                .orElseThrow();
    }

    private static int[] rates(Rig rig) {
        rig.pulse(0.1);
        return rates(rig.packets(0x98, 0.1).get(0));
    }

    private static int[] rates(byte[] packet) {
        return IntStream.range(0, packet[4])
                .map(i -> packet[5 + 3 * i] & 0xFF | (packet[6 + 3 * i] & 0xFF) << 8)
                .toArray();
    }
}

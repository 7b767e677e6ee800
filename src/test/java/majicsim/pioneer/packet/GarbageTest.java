package majicsim.pioneer.packet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import majicsim.pioneer.Rig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever comes, the robot stays in its room, keeps its rhythm and can be spoken to afterwards. */
class GarbageTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void noBytesUpsetIt(long seed) {
        Random random = new Random(seed);
        Rig rig = Rig.ready();
        for (int i = 0; i < 300; i++) {
            byte[] noise = new byte[1 + random.nextInt(300)];
            random.nextBytes(noise);
            rig.robot.received(rig.line, noise);
            rig.step(0.02);
        }
        assertAnswers(rig);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void noCommandUpsetsItWhateverItsArgument(long seed) {
        Random random = new Random(seed);
        Rig rig = Rig.ready();
        for (int i = 0; i < 2000; i++) {
            byte[] argument = new byte[random.nextInt(16)];
            random.nextBytes(argument);
            int id = random.nextInt(256);
            if (id != 2 && id < 253) {
                rig.packet(id, argument).step(0.02);
            }
        }
        assertAnswers(rig);
        assertThat(Math.abs(rig.pose().xMm())).isLessThan(5000);
        assertThat(Math.abs(rig.pose().yMm())).isLessThan(4000);
    }

    @Test
    void aLimitOfZeroStopsTheRobotAndALaterOneLetsItContinue() {
        Rig rig = Rig.ready()
                .command(6, 0)
                .command(8, 500)
                .command(10, 0)
                .command(12, 90)
                .step(1);
        assertThat(rig.nextSip().type()).isEqualTo(0x32);
        rig.command(6, 300).command(10, 90).pulse(5);
        assertThat(rig.nextSip().headingDeg()).isBetween(89.9, 90.1);
        assertThat(Math.hypot(rig.pose().xMm(), rig.pose().yMm())).isGreaterThan(300);
    }

    /** Half a packet may be under way; it is given up after half a second. */
    private static void assertAnswers(Rig rig) {
        rig.step(0.6);
        rig.line.take();
        rig.command(18, 1);
        assertThat(rig.line.take())
                .singleElement()
                .satisfies(packet -> assertThat(packet[3]).isEqualTo((byte) 0x20));
        rig.command(28, 1);
        assertThat(rig.step(0.2).sips()).hasSize(2);
    }
}

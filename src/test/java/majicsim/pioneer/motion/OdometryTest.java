package majicsim.pioneer.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majicsim.pioneer.Rig;
import majicsim.pioneer.packet.Hex;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OdometryTest {
    private static final int MOVE = 8;
    private static final int DHEAD = 13;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void theWheelsMisleadByOneToTwoPercentInWayAndTwoToFiveInTurning(long seed) {
        Rig rig = noisy(seed).command(MOVE, 2000).pulse(8);
        assertThat(rig.nextSip().x()).isEqualTo(2000);
        assertThat(Math.abs(rig.pose().xMm() / 2000 - 1)).isBetween(0.0099, 0.0201);
        rig.command(DHEAD, 100).pulse(4);
        assertThat(rig.nextSip().headingDeg()).isCloseTo(100, within(0.1));
        assertThat(Math.abs(rig.pose().headingDeg() / 100 - 1)).isBetween(0.0199, 0.0501);
    }

    @Test
    void theErrorIsTheSameForTheSameSeedAndForGood() {
        assertThat(noisy(5).command(MOVE, 1000).pulse(5).pose())
                .isEqualTo(noisy(5).command(MOVE, 1000).pulse(5).pose());
    }

    @Test
    void anArcAddsUpToACircle() {
        Rig rig =
                Rig.ready().command(5, 9000).command(23, 9000).command(11, 200).command(21, 40);
        rig.pulse(9);
        assertThat(Math.hypot(rig.nextSip().x(), rig.nextSip().y())).isLessThan(60);
        assertThat(rig.nextSip().y()).isCloseTo((int) Math.round(rig.pose().yMm()), within(1));
    }

    @Test
    void countersRollOverAtSixteenBits() {
        Rig rig = new Rig(new Pose(0, 0, 0), Noise.exact(), "p3dx").shakeHands().command(4, 1);
        rig.packet(7, "3B 06 3E 00 00 00 00");
        assertThat(rig.nextSip().x()).isEqualTo((int) Math.round(15878 / 0.485));
        rig.command(MOVE, 100).pulse(3);
        assertThat(rig.nextSip().x()).isEqualTo((int) Math.round(15978 / 0.485) - 65536);
    }

    @Test
    void encodersCountWhatTheWheelsDid() {
        Rig rig = Rig.ready().command(MOVE, 1000).pulse(5).command(19, 1);
        rig.line.take();
        assertThat(rig.step(0.1).line.take().get(1)).isEqualTo(Hex.bytes("FA FB 0B 90 00 F4 01 00 00 F4 01 00 78 02"));
    }

    private static Rig noisy(long seed) {
        return new Rig(new Pose(0, 0, 0), Noise.seeded(seed), "p3dx-sh")
                .shakeHands()
                .command(4, 1);
    }
}

package majicsim.pioneer.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Motion commands from the wire to the world (ARCOS sheet 7). */
class MotionTest {
    private static final int SETA = 5;
    private static final int SETV = 6;
    private static final int MOVE = 8;
    private static final int SETRV = 10;
    private static final int VEL = 11;
    private static final int HEAD = 12;
    private static final int DHEAD = 13;
    private static final int RVEL = 21;
    private static final int DCHEAD = 22;
    private static final int STOP = 29;
    private static final int ESTOP = 55;
    private static final Offset<Double> TENTH = within(0.1);

    @Test
    void velRisesThirtyMillimetresPerSecondASip() {
        Rig rig = Rig.ready().command(SETA, 300).command(VEL, 250);
        List<SipView> sips = rig.step(1).sips();
        assertThat(sips).extracting(SipView::left).containsExactly(30, 60, 90, 120, 150, 180, 210, 240, 250, 250);
        assertThat(sips).extracting(SipView::type).containsOnly(0x33);
        assertThat(rig.command(VEL, 0).pulse(1).sips())
                .extracting(SipView::right)
                .startsWith(220, 190, 160);
    }

    @ParameterizedTest
    @CsvSource({"1000", "-1000", "300", "-40"})
    void moveArrivesOnTheMillimetreInBothDirections(int mm) {
        Rig rig = Rig.ready().command(MOVE, mm).pulse(5);
        assertThat(rig.pose().xMm()).isCloseTo(mm, TENTH);
        assertThat(rig.nextSip().x()).isEqualTo(mm);
        assertThat(rig.nextSip().type()).isEqualTo(0x32);
    }

    @ParameterizedTest
    @CsvSource({"90, 90", "-90, -90", "270, -90", "359, -1", "170, 170"})
    void headTurnsTheShorterWayAndStopsThere(int asked, double heading) {
        Rig rig = Rig.ready();
        for (int i = 0; i < 60; i++) {
            rig.command(HEAD, asked).step(0.1);
        }
        assertThat(rig.pose().headingDeg()).isCloseTo(heading, TENTH);
        assertThat(rig.nextSip().headingDeg()).isCloseTo(heading, within(0.1));
        assertThat(rig.nextSip().control()).isEqualTo(rig.nextSip().heading());
    }

    @Test
    void headTakesAsLongAsItsRampsWhetherRepeatedOrNot() {
        Rig once = Rig.ready().command(HEAD, 90).step(1.9);
        Rig often = Rig.ready();
        for (int i = 0; i < 19; i++) {
            often.command(HEAD, 90).step(0.1);
        }
        assertThat(once.pose().headingDeg()).isCloseTo(90, TENTH);
        assertThat(often.pose().headingDeg()).isCloseTo(90, TENTH);
    }

    @Test
    void dheadCountsFromHereAndDcheadFromTheSetPoint() {
        Rig rig = Rig.ready().command(DHEAD, 30).command(DCHEAD, 30).pulse(3);
        assertThat(rig.pose().headingDeg()).isCloseTo(60, TENTH);
        assertThat(rig.command(DHEAD, -20).pulse(3).pose().headingDeg()).isCloseTo(40, TENTH);
    }

    @Test
    void theChannelsAreIndependent() {
        Rig rig = Rig.ready().command(VEL, 100).command(HEAD, 45).pulse(3);
        SipView sip = rig.nextSip();
        assertThat(sip.headingDeg()).isCloseTo(45, TENTH);
        assertThat(List.of(sip.left(), sip.right())).containsOnly(100);
        sip = rig.command(RVEL, -20).step(1).command(VEL, 0).pulse(1).nextSip();
        assertThat(sip.turnRateTenths()).isEqualTo(-200);
        assertThat(sip.left()).isEqualTo(62);
    }

    @ParameterizedTest
    @CsvSource({
        "FA FB 06 20 3B 0A 05 2A 40, 100",
        "FA FB 06 20 1B F6 04 16 1F, -100",
        "FA FB 06 20 3B 0A FB 2B 36, -100"
    })
    void vel2SetsTheWheels(String packet, int left) {
        SipView sip = Rig.ready().send(packet).step(1.5).nextSip();
        assertThat(sip.left()).isEqualTo(left);
        assertThat(sip.right()).isEqualTo(200);
    }

    @Test
    void velAfterVel2EndsItsTurning() {
        SipView sip = Rig.ready()
                .send("FA FB 06 20 3B 0A 05 2A 40")
                .step(1)
                .command(VEL, 100)
                .step(1)
                .nextSip();
        assertThat(List.of(sip.left(), sip.right())).containsOnly(100);
    }

    @Test
    void limitsHoldForEveryCommand() {
        Rig rig = Rig.ready().command(SETV, 200).command(SETRV, 20);
        SipView sip = rig.command(VEL, 500).command(RVEL, -60).step(1).nextSip();
        assertThat(sip.turnRateTenths()).isEqualTo(-200);
        assertThat((sip.left() + sip.right()) / 2).isEqualTo(200);
        rig.command(SETV, 9000).command(VEL, 5000).command(SETA, 9000).command(RVEL, 0);
        assertThat(rig.step(0.8).nextSip().left()).isEqualTo(2200);
    }

    @Test
    void stopBrakesAsSetAndEstopWithinOneCycle() {
        Rig rig = Rig.ready().command(VEL, 300).step(1.2).command(STOP, 0);
        assertThat(rig.nextSip().left()).isEqualTo(270);
        rig.pulse(1).command(VEL, 300).step(1.2).command(ESTOP, 0).command(VEL, 300);
        assertThat(rig.nextSip().left()).isZero();
        assertThat(rig.nextSip().hasMotors()).isTrue();
        assertThat(rig.nextSip().left()).isZero();
    }

    @Test
    void motorsAreOffAtFirstAndCommandsMeanwhileAreForgotten() {
        Rig rig = Rig.open()
                .command(VEL, 300)
                .command(MOVE, 500)
                .command(HEAD, 90)
                .step(0.5);
        assertThat(rig.nextSip().hasMotors()).isFalse();
        rig.command(4, 1).step(0.5);
        assertThat(rig.nextSip().hasMotors()).isTrue();
        assertThat(rig.pose()).isEqualTo(new Pose(0, 0, 0));
    }

    @Test
    void motorsSwitchedOffOnTheWayBrakeAndTheFlagClearsAtOnce() {
        Rig rig = Rig.ready().command(VEL, 300).step(1.2).command(4, 0);
        SipView sip = rig.nextSip();
        assertThat(sip.hasMotors()).isFalse();
        assertThat(sip.left()).isEqualTo(270);
        assertThat(rig.pulse(1).nextSip().left()).isZero();
        assertThat(rig.command(4, 1).step(0.5).nextSip().left()).isZero();
    }

    @Test
    void aCommandBetweenTwoStepsTakesEffectAtOnce() {
        Rig rig = Rig.ready().command(SETA, 9000).command(VEL, 250).step(0.5);
        double before = rig.pose().xMm();
        rig.command(SETA, -9000).command(VEL, 0).step(Rig.STEP_SECONDS);
        assertThat(rig.pose().xMm() - before).isCloseTo(250 * 0.004 - 9000 * 0.004 * 0.004 / 2, within(1e-6));
    }

    @Test
    void aModelWithoutMoveIgnoresIt() {
        Rig rig = new Rig(new Pose(0, 0, 0), Noise.exact(), "pioneer-lx").shakeHands();
        rig.command(4, 1).command(MOVE, 500).step(1);
        assertThat(rig.pose().xMm()).isZero();
    }
}

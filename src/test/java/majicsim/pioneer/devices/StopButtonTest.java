package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.PioneerHandling;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import org.junit.jupiter.api.Test;

/** The STOP button, E_STALL, and the flags of both (ARCOS sheet 6.1, 8.1). */
class StopButtonTest {
    private static final int ENABLE = 4;
    private static final int VEL = 11;
    private static final int E_STALL = 56;
    private static final int SONAR = 0x1E;
    private static final int PRESSED = 1 << 5;
    private static final int ENGAGED = 1 << 6;

    private final Rig rig = Rig.ready().command(VEL, 300).pulse(2);
    private final PioneerHandling handling = rig.robot.handling();

    @Test
    void pressedItStopsTheRobotAtOnceWithMotorsOffAndStalled() {
        handling.pressStop(true);
        rig.nextSip();
        SipView sip = rig.nextSip();
        assertThat(sip.left()).isZero();
        assertThat(sip.flags()).isEqualTo(SONAR | PRESSED | ENGAGED);
        assertThat(sip.isStalled()).isTrue();
    }

    @Test
    void whilePressedTheMotorsCannotBeEnabled() {
        handling.pressStop(true);
        rig.pulse(0.4).command(ENABLE, 1).command(VEL, 300);
        assertThat(rig.pulse(1).nextSip().hasMotors()).isFalse();
        assertThat(rig.nextSip().left()).isZero();
    }

    @Test
    void letGoItLeavesTheMotorsOffUntilTheyAreEnabled() {
        handling.pressStop(true);
        rig.pulse(1);
        handling.pressStop(false);
        SipView sip = rig.nextSip();
        assertThat(sip.flags()).isEqualTo(SONAR);
        assertThat(sip.isStalled()).isFalse();
        assertThat(rig.command(ENABLE, 1).command(VEL, 300).pulse(2).nextSip().left())
                .isEqualTo(300);
    }

    @Test
    void withEStallOffItIsShownAndHasNoEffect() {
        rig.command(E_STALL, 0);
        handling.pressStop(true);
        SipView sip = rig.nextSip();
        assertThat(sip.flags()).isEqualTo(SONAR | 1 | PRESSED);
        assertThat(sip.left()).isEqualTo(300);
    }
}

package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import org.junit.jupiter.api.Test;

/** JOYINFO and JOYDRIVE (ARCOS sheet 6.1, 11.4). */
class JoystickTest {
    private static final int JOYINFO = 17;
    private static final int JOYDRIVE = 47;
    private static final int FIRE_FLAG = 1 << 9;

    @Test
    void atRestItIsInItsCentre() {
        byte[] packet = Rig.open().command(JOYINFO, 1).packets(0xF8, 0.1).get(0);
        assertThat(packet).startsWith(0xFA, 0xFB, 0x0B, 0xF8, 0, 0, 0x00, 0x02, 0x00, 0x02, 0xFF, 0x03);
    }

    @Test
    void pushesAndButtonsShowInThePacketThatComesBeforeTheSip() {
        Rig rig = Rig.open().command(JOYINFO, 2);
        rig.robot.handling().pushJoystick(1, -1);
        rig.robot.handling().pressJoystick(true, false);
        rig.robot.handling().throttle(0);
        rig.line.take();
        assertThat(rig.step(0.1).line.take().get(0))
                .startsWith(0xFA, 0xFB, 0x0B, 0xF8, 1, 0, 0xFF, 0x03, 0x01, 0x00, 0, 0);
    }

    @Test
    void withAClientItDrivesOnlyWhenAllowedAndStopsWhenTheButtonIsLetGo() {
        Rig rig = Rig.ready();
        rig.robot.handling().pushJoystick(0, 0.5);
        rig.robot.handling().pressJoystick(true, false);
        assertThat(rig.pulse(2).nextSip().left()).isZero();
        SipView driving = rig.command(JOYDRIVE, 1).pulse(2).nextSip();
        assertThat(driving.left()).isEqualTo(300);
        assertThat(driving.flags() & FIRE_FLAG).isEqualTo(FIRE_FLAG);
        rig.robot.handling().pressJoystick(false, false);
        SipView standing = rig.pulse(2).nextSip();
        assertThat(standing.left()).isZero();
        assertThat(standing.flags()).isEqualTo(0x1F);
    }

    @Test
    void theButtonSwitchesNoMotorsOnForAClientThatHasThemOff() {
        Rig rig = Rig.open().command(JOYDRIVE, 1);
        rig.robot.handling().pushJoystick(0, 1);
        rig.robot.handling().pressJoystick(true, false);
        assertThat(rig.pulse(1).nextSip().left()).isZero();
    }

    @Test
    void withoutAClientItDrivesAtOnceAndPushingRightTurnsRight() {
        Rig rig = Rig.silent();
        rig.robot.handling().pushJoystick(0.5, 0);
        rig.robot.handling().pressJoystick(true, false);
        rig.step(2);
        assertThat(rig.body().turnDegPerSec()).isCloseTo(-30, within(0.01));
        rig.robot.handling().pressJoystick(false, false);
        assertThat(rig.step(1).body().turnDegPerSec()).isZero();
        assertThat(rig.shakeHands().nextSip().hasMotors()).isFalse();
    }
}

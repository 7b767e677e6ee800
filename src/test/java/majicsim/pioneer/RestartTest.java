package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.packet.Hex;
import org.junit.jupiter.api.Test;

/** RESET, MAINTENANCE and the reset button (ARCOS sheet 6.1, 11.6). */
class RestartTest {
    private static final int RESET = 253;
    private static final int MAINTENANCE = 255;
    private static final String SYNC0 = "FA FB 03 00 00 00";

    private final Rig rig = Rig.ready();

    @Test
    void resetNotifiesTheClientAndForgetsIt() {
        rig.line.take();
        rig.command(RESET, 0);
        assertThat(rig.line.take()).singleElement().isEqualTo(Hex.bytes("FA FB 03 FE 00 FE"));
        assertThat(rig.step(0.9).send(SYNC0).line.take()).isEmpty();
        assertThat(rig.step(0.2).send(SYNC0).line.take()).hasSize(1);
    }

    @Test
    void whatFollowsInTheSameReadIsLost() {
        rig.line.take();
        rig.send("FA FB 03 FD 00 FD " + SYNC0);
        assertThat(rig.step(1.1).line.take()).hasSize(1);
    }

    @Test
    void afterResetAllIsAsAfterSwitchingOn() {
        rig.command(5, 50).command(30, 0xFF00).command(35, 3).command(250, 117).command(11, 300);
        rig.pulse(1).command(RESET, 0).step(1.2);
        rig.shakeHands();
        assertThat(rig.config().number("TRANSACC")).isEqualTo(300);
        SipView sip = rig.nextSip();
        assertThat(sip.digitalOut()).isEqualTo(0xFF);
        assertThat(sip.analogPort()).isZero();
        assertThat(sip.battery()).isEqualTo(130);
        assertThat(sip.x()).isZero();
        assertThat(sip.hasMotors()).isFalse();
    }

    @Test
    void theClockStartsAnewWithTheController() {
        long before = rig.pulse(4).nextSip().clockMicros();
        assertThat(rig.nextSip().clockMicros() - before).isEqualTo(100_000);
        rig.robot.handling().pressReset();
        rig.step(1.2).shakeHands();
        assertThat(rig.nextSip().clockMicros()).isLessThan(2_000_000);
    }

    @Test
    void inMaintenanceItIsOutOfReachUntilTheButtonIsPressed() {
        rig.command(11, 300).pulse(1).command(MAINTENANCE, 1).line.take();
        assertThat(rig.step(5).send(SYNC0).line.take()).isEmpty();
        assertThat(rig.body().speedMmPerSec()).isZero();
        assertThat(rig.reconnect().command(RESET, 0).step(2).send(SYNC0).line.take())
                .isEmpty();
        rig.robot.handling().pressReset();
        rig.step(1.1).line.take();
        assertThat(rig.send(SYNC0).line.take()).hasSize(1);
    }

    @Test
    void theButtonWorksWithoutAClient() {
        rig.robot.disconnected(rig.line);
        rig.robot.handling().pressReset();
        rig.step(1.1).robot.connected(rig.line);
        assertThat(rig.shakeHands().nextSip().flags()).isEqualTo(0x1E);
    }
}

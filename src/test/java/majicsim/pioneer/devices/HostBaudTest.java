package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.Rig;
import org.junit.jupiter.api.Test;

/** HOSTBAUD and its way back (ARCOS sheet 6.1). */
class HostBaudTest {
    private static final int HOSTBAUD = 50;

    private final Rig rig = Rig.open();

    @Test
    void itStartsAt9600AndChangesAtOnce() {
        assertThat(rig.robot.hostBaud()).isEqualTo(9600);
        assertThat(rig.command(HOSTBAUD, 2).robot.hostBaud()).isEqualTo(38_400);
    }

    @Test
    void aPacketWithinHalfASecondConfirmsIt() {
        rig.command(HOSTBAUD, 4).step(0.4).command(0, 0).step(1);
        assertThat(rig.robot.hostBaud()).isEqualTo(115_200);
        assertThat(rig.config().number("HOSTBAUD")).isEqualTo(4);
    }

    @Test
    void silenceOrInvalidDataRestoresTheOldSpeed() {
        rig.command(HOSTBAUD, 2).command(0, 0).step(0.6);
        rig.command(HOSTBAUD, 1).step(0.2).send("FA FB 03 00 00 01").step(0.296);
        assertThat(rig.robot.hostBaud()).isEqualTo(19_200);
        assertThat(rig.step(0.004).robot.hostBaud()).isEqualTo(38_400);
    }

    @Test
    void codesThatMeanNothingAreIgnored() {
        assertThat(rig.command(HOSTBAUD, 5).command(HOSTBAUD, -1).robot.hostBaud())
                .isEqualTo(9600);
    }

    @Test
    void theEndOfTheSessionIsTheEndOfTheSpeed() {
        assertThat(rig.command(HOSTBAUD, 2).command(0, 0).command(2, 1).robot.hostBaud())
                .isEqualTo(9600);
    }
}

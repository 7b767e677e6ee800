package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majicsim.pioneer.PioneerHandling;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

/** Inputs and outputs in the SIP and in the IO packet (ARCOS sheet 8, 11.2). */
class UserPortTest {
    private static final int DIGOUT = 30;
    private static final int ADSEL = 35;
    private static final int IOREQUEST = 40;

    private final Rig rig = Rig.open();
    private final PioneerHandling handling = rig.robot.handling();

    @Test
    void aClosedContactReadsZero() {
        handling.digitalInput(2, true);
        assertThat(rig.nextSip().digitalIn()).isEqualTo(0b1111_1011);
        handling.digitalInput(2, false);
        assertThat(rig.nextSip().digitalIn()).isEqualTo(0xFF);
    }

    @Test
    void onlyTheOutputsInTheMaskChange() {
        assertThat(rig.command(DIGOUT, 0x0F05).nextSip().digitalOut()).isEqualTo(0xF5);
        assertThat(rig.command(DIGOUT, 0xF000).nextSip().digitalOut()).isEqualTo(0x05);
        assertThat(rig.packet(DIGOUT, "1B FF FF").nextSip().digitalOut()).isEqualTo(0x05);
    }

    @Test
    void theSipShowsTheAnalogPortThatWasChosen() {
        handling.analogInput(3, 2.5);
        assertThat(rig.nextSip().analog()).isZero();
        SipView sip = rig.command(ADSEL, 3).nextSip();
        assertThat(sip.analogPort()).isEqualTo(3);
        assertThat(sip.analog()).isEqualTo(128);
        assertThat(rig.command(ADSEL, 99).nextSip().analog()).isZero();
    }

    @Test
    void theIoPacketCountsWhatItCarriesAndEndsWithTheBattery() {
        handling.digitalInput(0, true);
        handling.infrared(7, true);
        handling.analogInput(1, 5);
        byte[] packet = rig.command(IOREQUEST, 1).packets(0xF0, 0.1).get(0);
        assertThat(packet).startsWith(0xFA, 0xFB, 0x1D, 0xF0, 4, 0xFE, 0xFF, 0xFF, 0x7F, 1, 0xFF, 9, 0, 0, 0xFF, 3);
        assertThat(packet[28] & 0xFF | packet[29] << 8).isEqualTo(130 * 4);
        assertThat(packet).hasSize(0x1D + 3);
    }

    @Test
    void bumpersInTheIoPacketAreActiveLow() {
        Rig bumping = new Rig(new Pose(4700, 0, 0), Noise.exact(), "peoplebot-sh")
                .shakeHands()
                .command(4, 1)
                .command(11, 100)
                .pulse(2);
        byte[] packet = bumping.command(IOREQUEST, 1).packets(0xF0, 0.1).get(0);
        assertThat(Integer.bitCount(packet[6] & 0xFF)).isEqualTo(7);
        assertThat(packet[7]).isEqualTo((byte) 0xFF);
    }

    @Test
    void aLedgeShowsInTheFlags() {
        handling.ledge(true, false);
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E | 1 << 7);
        handling.ledge(false, true);
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E | 1 << 8);
    }

    @Test
    void inputsThatThereAreNotAreRefused() {
        assertThatThrownBy(() -> handling.digitalInput(8, true)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> handling.analogInput(8, 1)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> handling.infrared(-1, true)).isInstanceOf(IndexOutOfBoundsException.class);
    }
}

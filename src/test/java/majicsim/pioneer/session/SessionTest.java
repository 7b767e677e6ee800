package majicsim.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Handshake to CLOSE (ARCOS sheet 4, 5, 11), stepped by hand. */
class SessionTest {
    private static final int CLOSE = 2;
    private static final int VEL = 11;

    @Test
    void nothingComesBeforeOpenAndTheFirstSipOneCycleAfter() {
        Rig rig = Rig.silent().send("FA FB 03 00 00 00  FA FB 03 01 00 01  FA FB 03 02 00 02");
        assertThat(rig.line.take()).hasSize(3);
        assertThat(rig.step(0.5).line.take()).isEmpty();
        assertThat(rig.command(1, 1).step(0.096).line.take()).isEmpty();
        assertThat(rig.step(0.004).sips()).extracting(SipView::type).containsExactly(0x32);
    }

    @Test
    void sipsComeEveryHundredMillisecondsEachInOneWrite() {
        Rig rig = Rig.open().command(1, 1);
        rig.line.take();
        for (int i = 0; i < 20; i++) {
            assertThat(rig.step(0.096).line.take()).isEmpty();
            assertThat(rig.step(0.004).line.take())
                    .singleElement()
                    .satisfies(packet -> assertThat(packet[2] + 3).isEqualTo(packet.length));
        }
    }

    @Test
    void configIsAnsweredAtOnceWithOrWithoutArgument() {
        Rig rig = Rig.open();
        rig.line.take();
        rig.command(18, 1).send("FA FB 03 12 00 12");
        assertThat(rig.line.take())
                .hasSize(2)
                .allSatisfy(packet -> assertThat(packet[3]).isEqualTo((byte) 0x20));
    }

    @Test
    void aSyncInAnOpenSessionIsAPulse() {
        Rig rig = Rig.open();
        rig.line.take();
        rig.send("FA FB 03 00 00 00");
        assertThat(rig.step(0.1).line.take()).hasSize(1).allMatch(SipView::isSip);
    }

    @Test
    void twoSecondsOfSilenceStopTheRobotUntilTheNextPacket() {
        Rig rig = Rig.ready().command(VEL, 300).step(1.996);
        assertThat(rig.step(0.004).nextSip().left()).isEqualTo(270);
        assertThat(rig.step(2).nextSip().left()).isZero();
        assertThat(rig.command(0, 0).nextSip().left()).isEqualTo(30);
        assertThat(rig.step(1).nextSip().left()).isEqualTo(300);
    }

    @Test
    void aWrongChecksumIsNoSignOfLife() {
        Rig rig = Rig.ready()
                .command(VEL, 300)
                .step(1.5)
                .send("FA FB 03 00 00 01")
                .step(0.5);
        assertThat(rig.nextSip().left()).isEqualTo(270);
    }

    @Test
    void aWayInterruptedByTheWatchdogIsFinishedAfterwards() {
        Rig rig = Rig.ready().command(6, 300).command(8, 1500).step(6);
        assertThat(rig.pose().xMm()).isCloseTo(300 * 1.5 + 150, within(2.0));
        assertThat(rig.pulse(6).pose().xMm()).isCloseTo(1500, within(0.01));
    }

    @Test
    void closeStopsHangsUpAndForgetsWhatWasSet() {
        Rig rig = Rig.ready()
                .command(6, 100)
                .command(5, 50)
                .command(250, 117)
                .command(VEL, 300)
                .step(1);
        rig.command(CLOSE, 1).command(VEL, 300);
        assertThat(rig.line.isOpen()).isFalse();
        rig.step(2).reconnect();
        rig.shakeHands();
        SipView sip = rig.nextSip();
        assertThat(List.of(sip.x(), sip.left(), sip.battery())).containsExactly(0, 0, 117);
        assertThat(sip.hasMotors()).isFalse();
        assertThat(rig.pose().xMm()).isGreaterThan(10);
        assertThat(rig.command(4, 1).command(VEL, 250).step(0.1).nextSip().left())
                .isEqualTo(60);
    }

    @Test
    void theRobotStopsWhenItsClientDisconnects() {
        Rig rig = Rig.ready().command(VEL, 300).step(1.2);
        rig.reconnect();
        rig.step(2);
        assertThat(rig.line.take()).isEmpty();
        assertThat(rig.body().speedMmPerSec()).isZero();
        assertThat(rig.shakeHands().nextSip().hasMotors()).isFalse();
    }

    @Test
    void halfAPacketIsForgottenAfterHalfASecond() {
        Rig rig = Rig.ready().send("FA FB C8 04 3B").command(VEL, 300);
        assertThat(rig.step(0.4).nextSip().left()).isZero();
        assertThat(rig.step(0.1).nextSip().left()).isGreaterThan(0);
    }

    @ParameterizedTest
    @ValueSource(ints = {14, 34, 70, 81, 95, 110, 150, 199, 239, 254})
    void unknownCommandsAreIgnored(int id) {
        Rig rig = Rig.open().command(id, 1);
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E);
        assertThat(rig.line.isOpen()).isTrue();
    }

    @Test
    void setoZeroesOdometryAndLeavesTheRobotWhereItIs() {
        Rig rig = Rig.ready().command(8, 500).pulse(4).send("FA FB 04 07 3B 07 3B");
        assertThat(rig.nextSip().x()).isZero();
        assertThat(rig.pose().xMm()).isCloseTo(500, within(0.1));
        rig.packet(7, "3B 0A 00 F6 FF 5A 00");
        SipView sip = rig.nextSip();
        assertThat(List.of(sip.x(), sip.y(), sip.heading())).containsExactly(10, -10, 1024);
    }

    @Test
    void outputsAndTheAnalogPortShowInTheSip() {
        SipView sip = Rig.open().command(30, 0x0F05).command(35, 3).nextSip();
        assertThat(sip.digitalOut()).isEqualTo(0xF5);
        assertThat(sip.analogPort()).isEqualTo(3);
    }

    @Test
    void extraPacketsComeInTheirOrderAndAsOftenAsRequested() {
        Rig rig = Rig.open().command(19, 2).command(40, 1).command(62, 1).command(237, 2);
        rig.line.take();
        assertThat(rig.step(0.1).line.take())
                .extracting(packet -> packet[3] & 0xFF)
                .containsExactly(0x62, 0x32, 0xF0, 0x90, 0xFA);
        assertThat(rig.step(0.1).line.take())
                .extracting(packet -> packet[3] & 0xFF)
                .containsExactly(0x62, 0x32, 0x90);
        rig.command(19, 0).command(237, 0);
        assertThat(rig.step(0.1).line.take())
                .extracting(packet -> packet[3] & 0xFF)
                .containsExactly(0x32);
    }

    @Test
    void theSimulatorsOwnCommandsMoveTheRobotAndNotItsOdometry() {
        Rig rig = Rig.open().send("FA FB 10 E0 3B 60 F0 FF FF 48 F4 FF FF 2D 00 00 00 B7 1D");
        assertThat(rig.pose()).isEqualTo(new Pose(-4000, -3000, 45));
        assertThat(rig.nextSip().x()).isZero();
        rig.send("FA FB 03 E1 00 E1");
        assertThat(rig.pose()).isEqualTo(new Pose(0, 0, 0));
    }

    @Test
    void aPlaceInsideAWallIsRefused() {
        Rig rig = Rig.open().packet(224, "3B 88 13 00 00 00 00 00 00 00 00 00 00");
        assertThat(rig.pose()).isEqualTo(new Pose(0, 0, 0));
    }
}

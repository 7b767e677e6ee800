package majicsim.pioneer.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majicsim.net.Firmware;
import majicsim.pioneer.FakeLine;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.pioneer.packet.Hex;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The plug at the robot's side, where a real controller has no notion of a connection (ARCOS sheet 5.1, 15). */
class SerialPortTest {
    private static final byte[] HANDS = Hex.bytes("FA FB 03 00 00 00 FA FB 03 01 00 01 FA FB 03 02 00 02");
    private static final byte[] RADIO_NOISE = Hex.bytes("57 4D 53 32 0D");
    private static final byte[] OPEN = Hex.bytes("FA FB 03 01 00 01");
    private static final byte[] CLOSE = Hex.bytes("FA FB 03 02 00 02");
    private static final byte[] ENABLE_AND_VEL_250 = Hex.bytes("FA FB 06 04 3B 01 00 05 3B FA FB 06 0B 3B FA 00 05 3B");

    private final Rig rig = Rig.silent();
    private final Firmware port = rig.robot.serialPort();
    private FakeLine serial = new FakeLine();

    @BeforeEach
    void plugIn() {
        rig.robot.disconnected(rig.line);
        port.connected(serial);
    }

    @Test
    void closeLeavesTheLineOpenForTheNextHandshake() {
        for (int i = 0; i < 3; i++) {
            assertThat(say(Hex.concat(RADIO_NOISE, HANDS))).hasSize(3);
            say(Hex.concat(OPEN, CLOSE));
            assertThat(serial.isOpen()).isTrue();
        }
    }

    @Test
    void aClientThatVanishesIsNoticedByTheWatchdogAloneAndTheNextOneMeetsSips() {
        say(Hex.concat(HANDS, OPEN, ENABLE_AND_VEL_250));
        rig.step(1);
        assertThat(rig.body().speedMmPerSec()).isEqualTo(250);
        port.disconnected(serial);
        rig.step(3);
        assertThat(rig.body().speedMmPerSec()).isZero();
        serial = new FakeLine();
        port.connected(serial);
        say(Hex.bytes("FA FB 03 00 00 00"));
        rig.step(0.1);
        assertThat(serial.take()).isNotEmpty().allMatch(SipView::isSip);
    }

    @Test
    void aNetworkClientIsTurnedAwayWhileASerialSessionIsUnderWay() {
        say(HANDS);
        FakeLine network = new FakeLine();
        rig.robot.connected(network);
        assertThat(network.isOpen()).isFalse();
        say(CLOSE);
        FakeLine later = new FakeLine();
        rig.robot.connected(later);
        assertThat(later.isOpen()).isTrue();
    }

    @Test
    void aNetworkClientTakesOverFromASerialOneThatHasFallenSilent() {
        say(Hex.concat(HANDS, OPEN, ENABLE_AND_VEL_250));
        rig.step(2.1);
        rig.reconnect();
        assertThat(rig.line.isOpen()).isTrue();
        assertThat(rig.shakeHands().nextSip().hasMotors()).isFalse();
        assertThat(serial.take()).allMatch(SipView::isSip);
    }

    @Test
    void aHandshakeLeftHalfDoneBeginsAnewAfterTenSeconds() {
        say(Hex.bytes("FA FB 03 00 00 00 FA FB 03 01 00 01"));
        rig.step(10);
        assertThat(say(Hex.bytes("FA FB 03 02 00 02"))).containsExactly(Hex.bytes("FA FB 03 FF 00 FF"));
        assertThat(say(HANDS)).hasSize(3);
    }

    @Test
    void thePlugIsIgnoredWhileANetworkClientIsConnected() {
        rig.robot.connected(rig.line);
        rig.shakeHands();
        assertThat(say(HANDS)).isEmpty();
        rig.robot.disconnected(rig.line);
        assertThat(say(HANDS)).hasSize(3);
    }

    private List<byte[]> say(byte[] bytes) {
        port.received(serial, bytes);
        return serial.take();
    }
}

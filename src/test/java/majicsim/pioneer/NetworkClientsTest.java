package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.Packet;
import majicsim.world.Noise;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Clients over a real socket that do it wrong, or come when they should not (ARCOS sheet 4, 14, 15). */
@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class NetworkClientsTest {
    private static final int OPEN = 1;
    private static final int CLOSE = 2;
    private static final int ENABLE = 4;
    private static final int VEL = 11;
    private static final int DIGOUT = 30;
    private static final int ADSEL = 35;
    private static final int LOST_STEP = 0xFF;

    @AutoClose
    private Stand stand;

    @BeforeEach
    void open() throws IOException {
        stand = new Stand(Noise.exact());
    }

    @Test
    void aSecondClientIsTurnedAwayAtOnceAndTheFirstDrivesOn() throws IOException {
        StandClient first = connected();
        first.command(ENABLE, 1);
        first.command(VEL, 200);
        for (int i = 0; i < 5; i++) {
            Wire second = stand.secondClient();
            assertThat(second.read(1)).isEmpty();
            second.vanish();
        }
        assertThat(first.sipAfter(1).left()).isEqualTo(200);
    }

    @Test
    void aClientThatComesRightAfterCloseIsServed() throws IOException {
        for (int i = 0; i < 20; i++) {
            StandClient client = connected();
            client.command(CLOSE);
            client.awaitEnd();
        }
        assertThat(connected().sip().type()).isEqualTo(0x32);
    }

    @Test
    void aClientThatNeverSendsMakesRoomForTheNextAfterTenSeconds() throws IOException {
        StandClient silent = stand.tcpClient();
        stand.step(9.9);
        assertThat(stand.secondClient().read(1)).isEmpty();
        stand.step(0.2);
        silent.awaitEnd();
        assertThat(connected().sip().type()).isEqualTo(0x32);
    }

    @Test
    void aClientThatStopsHalfWayThroughTheHandshakeDoesToo() throws IOException {
        StandClient half = stand.tcpClient();
        half.command(0);
        stand.step(10);
        half.awaitEnd();
        connected();
    }

    @Test
    void aSyncOutOfOrderMakesTheClientStartOver() throws IOException {
        StandClient client = stand.tcpClient();
        for (int wrong : new int[] {2, 4, 11}) {
            client.command(0);
            client.command(wrong);
            assertThat(client.during(0)).extracting(Packet::id).containsExactly(0, LOST_STEP);
        }
        shakeHands(client);
    }

    @Test
    void aBurstInOneWriteIsObeyedHoweverItIsCut() throws IOException {
        StandClient client = connected();
        int length = burst(0).length;
        for (int cut = 1; cut < length; cut++) {
            byte[] burst = burst(cut);
            client.write(Arrays.copyOfRange(burst, 0, cut));
            client.write(Arrays.copyOfRange(burst, cut, length));
            SipView sip = client.sip();
            assertThat(List.of(sip.digitalOut(), sip.analogPort())).containsExactly(cut, cut % 8);
        }
    }

    @Test
    void rubbishBetweenPacketsDoesNotReachTheRobot() throws IOException {
        StandClient client = connected();
        Random random = new Random(11);
        for (int i = 0; i < 200; i++) {
            byte[] rubbish = new byte[random.nextInt(60)];
            random.nextBytes(rubbish);
            client.write(rubbish);
            client.write(new byte[256]);
            client.command(DIGOUT, 0xFF00 + i);
            assertThat(client.sip().digitalOut()).isEqualTo(i);
        }
    }

    @Test
    void aDamagedPacketIsDroppedAndTheNextOneObeyed() throws IOException {
        StandClient client = connected();
        byte[] damaged = StandClient.packet(ENABLE, 1);
        damaged[5] ^= 1;
        client.write(Hex.concat(damaged, StandClient.packet(ADSEL, 5)));
        SipView sip = client.sip();
        assertThat(sip.hasMotors()).isFalse();
        assertThat(sip.analogPort()).isEqualTo(5);
    }

    /** As the vendor's client sends its settings: many packets, one write. */
    private static byte[] burst(int number) {
        return Hex.concat(
                StandClient.packet(0),
                StandClient.packet(DIGOUT, 0xFF00 + number),
                StandClient.packet(199, 7),
                StandClient.packet(ADSEL, number % 8),
                StandClient.packet(0));
    }

    private StandClient connected() throws IOException {
        StandClient client = stand.tcpClient();
        shakeHands(client);
        client.command(OPEN, 1);
        return client;
    }

    private static void shakeHands(StandClient client) throws IOException {
        for (int sync = 0; sync < 3; sync++) {
            client.command(sync);
            assertThat(client.during(0)).extracting(Packet::id).containsExactly(sync);
        }
    }
}

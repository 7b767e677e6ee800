package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import majicsim.pioneer.Rig;
import org.junit.jupiter.api.Test;

/** TTY, GETAUX and the packets they bring (ARCOS sheet 6.1, 11.6). */
class AuxPortTest {
    private static final int TTY2 = 42;
    private static final int GETAUX = 43;
    private static final int AUX1BAUD = 51;
    private static final int AUX1 = 0xB0;
    private static final byte[] HELLO = "hello".getBytes(StandardCharsets.US_ASCII);

    private final Rig rig = Rig.open();

    @Test
    void whatGoesOutComesBackFromTheLoopbackPlug() {
        rig.text(TTY2, HELLO).command(GETAUX, 5);
        assertThat(data(rig.packets(AUX1, 0.2))).isEqualTo("hello");
    }

    @Test
    void withoutARequestNothingIsSent() {
        assertThat(rig.text(TTY2, HELLO).packets(AUX1, 0.5)).isEmpty();
        assertThat(data(rig.command(GETAUX, 2).packets(AUX1, 0.2))).isEqualTo("he");
        assertThat(data(rig.command(GETAUX, 200).packets(AUX1, 0.2))).isEqualTo("llo");
    }

    @Test
    void aRequestForZeroBytesDiscardsTheWaitingOnes() {
        rig.text(TTY2, HELLO).pulse(0.5).command(GETAUX, 0).command(GETAUX, 5);
        assertThat(rig.packets(AUX1, 0.5)).isEmpty();
    }

    @Test
    void bytesTakeTheTimeOfThePortsBaudRate() {
        byte[] many = new byte[190];
        Arrays.fill(many, (byte) 'x');
        rig.text(TTY2, many).command(GETAUX, 200);
        assertThat(data(rig.packets(AUX1, 0.1))).hasSizeBetween(80, 96);
        assertThat(data(rig.packets(AUX1, 0.2))).hasSizeBetween(94, 110);
        rig.command(AUX1BAUD, 4).text(TTY2, many).command(GETAUX, 200);
        assertThat(data(rig.packets(AUX1, 0.1))).hasSize(190);
    }

    @Test
    void noPacketIsLongerThanTheProtocolAllows() {
        rig.command(AUX1BAUD, 4);
        rig.robot.handling().plugAux(1, bytes -> new byte[250]);
        List<byte[]> packets = rig.text(TTY2, (byte) 1).command(GETAUX, 200).packets(AUX1, 0.3);
        assertThat(packets).extracting(packet -> packet.length).containsExactly(200, 12);
    }

    @Test
    void anotherDeviceAnswersInItsOwnWay() {
        rig.robot.handling().plugAux(2, bytes -> new byte[] {'O', 'K'});
        rig.text(66, (byte) '?').command(67, 2);
        assertThat(data(rig.packets(0xB8, 0.2))).isEqualTo("OK");
    }

    private static String data(List<byte[]> packets) {
        StringBuilder text = new StringBuilder();
        for (byte[] packet : packets) {
            text.append(new String(packet, 4, packet.length - 6, StandardCharsets.US_ASCII));
        }
        return text.toString();
    }
}

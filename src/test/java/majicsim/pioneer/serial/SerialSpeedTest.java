package majicsim.pioneer.serial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import majicsim.net.Firmware;
import majicsim.pioneer.FakeLine;
import majicsim.pioneer.PioneerRobot;
import majicsim.pioneer.Rig;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.Packet;
import majicsim.pioneer.packet.PacketReader;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The speed of the serial line (ARCOS sheet 1 and 6.1, HOSTBAUD): bytes take time, and both ends must agree. */
class SerialSpeedTest {
    private static final byte[] SYNC0 = Hex.bytes("FA FB 03 00 00 00");
    private static final byte[] SYNC1 = Hex.bytes("FA FB 03 01 00 01");
    private static final byte[] SYNC2 = Hex.bytes("FA FB 03 02 00 02");
    private static final byte[] OPEN = Hex.bytes("FA FB 06 01 3B 01 00 02 3B");
    private static final byte[] CLOSE = Hex.bytes("FA FB 06 02 3B 01 00 03 3B");
    private static final byte[] PULSE = SYNC0;
    private static final byte[] CONFIG = Hex.bytes("FA FB 03 12 00 12");
    private static final byte[] HOSTBAUD_38400 = Hex.bytes("FA FB 06 32 3B 02 00 34 3B");
    private static final int CONFIG_TYPE = 0x20;

    private final Rig rig = new Rig(new Pose(0, 0, 0), Noise.seeded(1), PioneerRobot.STANDARD_MODEL);
    private final Firmware port = rig.robot.serialPort();
    private final FakeLine serial = new FakeLine();
    private final PacketReader reader = new PacketReader();

    @BeforeEach
    void plugIn() {
        rig.robot.disconnected(rig.line);
        serial.baud = 9600;
        port.connected(serial);
    }

    @Test
    void bytesComeNoFasterThanTenBitsEach() {
        open();
        say(CONFIG);
        List<Integer> perStep = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            rig.step(0.004);
            perStep.add(serial.take().stream().mapToInt(bytes -> bytes.length).sum());
        }
        assertThat(perStep).allMatch(bytes -> bytes <= 4);
    }

    @Test
    void theConfigPacketTakesAsLongAsItsBytesNeed() {
        shakeHands();
        say(CONFIG);
        double seconds = 0;
        int bytes = 0;
        while (reader.feed(concat(serial.take())).isEmpty()) {
            bytes++;
            rig.step(0.004);
            seconds += 0.004;
        }
        assertThat(bytes).isPositive();
        assertThat(seconds).isCloseTo((CONFIG.length + 150) * 10 / 9600.0, within(0.04));
    }

    @Test
    void aClientAtAnotherSpeedReceivesRubbishAndIsIgnored() {
        serial.baud = 38_400;
        assertThat(answers(SYNC0)).isEmpty();
        serial.baud = 9600;
        open();
        serial.baud = 38_400;
        assertThat(answers(CONFIG)).isEmpty();
    }

    @Test
    void theVendorsClientGoesTo38400AndIsFastThere() {
        open();
        say(HOSTBAUD_38400);
        rig.step(0.02);
        serial.take();
        serial.baud = 38_400;
        say(PULSE);
        rig.step(0.1);
        assertThat(rig.robot.hostBaud()).isEqualTo(38_400);
        assertThat(answers(CONFIG)).contains(CONFIG_TYPE);
        say(CLOSE);
        rig.step(0.1);
        assertThat(rig.robot.hostBaud()).isEqualTo(9600);
    }

    @Test
    void withoutAPacketAtTheNewSpeedItFallsBack() {
        open();
        say(HOSTBAUD_38400);
        rig.step(0.02);
        assertThat(rig.robot.hostBaud()).isEqualTo(38_400);
        rig.step(0.5);
        assertThat(rig.robot.hostBaud()).isEqualTo(9600);
        assertThat(answers(CONFIG)).contains(CONFIG_TYPE);
    }

    @Test
    void closingAtEverySpeedFreesASessionThatWasLeftAtAnUnknownOne() {
        open();
        say(HOSTBAUD_38400);
        rig.step(0.02);
        serial.baud = 38_400;
        say(PULSE);
        rig.step(5);
        for (int baud : new int[] {9600, 38_400, 115_200, 19_200, 57_600}) {
            serial.baud = baud;
            say(CLOSE);
            rig.step(0.004);
        }
        rig.step(0.2);
        serial.baud = 9600;
        serial.take();
        shakeHands();
    }

    private void open() {
        shakeHands();
        say(OPEN);
        rig.step(0.05);
    }

    private void shakeHands() {
        for (byte[] sync : List.of(SYNC0, SYNC1, SYNC2)) {
            assertThat(answers(sync)).contains((int) sync[3]);
        }
    }

    /** The types of all packets that come within 0.3 s of these bytes. */
    private List<Integer> answers(byte[] bytes) {
        say(bytes);
        rig.step(0.3);
        return reader.feed(concat(serial.take())).stream().map(Packet::id).toList();
    }

    private void say(byte[] bytes) {
        port.received(serial, bytes);
    }

    private static byte[] concat(List<byte[]> pieces) {
        return Hex.concat(pieces.toArray(byte[][]::new));
    }
}

package majicsim.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import majicsim.pioneer.Rig;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.Packet;
import majicsim.pioneer.packet.PacketReader;
import majicsim.pioneer.packet.PacketWriter;

/**
 * Whatever bytes come from a client: found and kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ReceivingFuzzTest {
    private static final byte[] HANDSHAKE = Hex.bytes("FA FB 03 00 00 00  FA FB 03 01 00 01  FA FB 03 02 00 02");
    private static final HexFormat HEX = HexFormat.of();
    private static final int CLOSE = 2;

    /** Out of it leads only the reset button. */
    private static final int MAINTENANCE = 255;

    /** Longer than a controller receives nothing after a reset, and than half a packet waits. */
    private static final double RESTART_S = 1.1;

    @FuzzTest
    void theSamePacketsComeHoweverTheBytesAreCut(byte[] wire) {
        List<String> whole = decode(new PacketReader(), wire, wire.length + 1);
        int chunkSize = wire.length == 0 ? 1 : 1 + (wire[0] & 0x3F);

        assertThat(decode(new PacketReader(), wire, chunkSize)).isEqualTo(whole);
        assertThat(decode(new PacketReader(), wire, 1)).isEqualTo(whole);
    }

    @FuzzTest
    void onlyWhatWasSentIsTakenForAPacket(byte[] wire) {
        String sent = HEX.formatHex(wire);

        for (Packet packet : new PacketReader().feed(wire)) {
            PacketWriter again = new PacketWriter(packet.id());
            for (byte b : packet.data()) {
                again.uint8(b & 0xFF);
            }
            assertThat(sent).contains(HEX.formatHex(again.toBytes()));
        }
    }

    @FuzzTest
    void aHandshakeWorksAfterAnyNoise(byte[] noise) {
        if (new PacketReader().feed(noise).stream().anyMatch(packet -> packet.id() == MAINTENANCE)) {
            return;
        }
        Rig rig = Rig.silent();
        rig.robot.received(rig.line, noise);
        rig.reconnect();

        assertAnswersAHandshake(rig);
    }

    @FuzzTest
    void aSessionStandsAnyCommands(byte[] plan) {
        Rig rig = Rig.ready();
        int at = 0;
        while (at + 2 <= plan.length && rig.line.isOpen()) {
            int end = Math.min(at + 2 + (plan[at] & 0x0F), plan.length);
            int id = plan[at + 1] & 0xFF;
            rig.packet(id == MAINTENANCE ? CLOSE : id, Arrays.copyOfRange(plan, at + 2, end))
                    .step(Rig.STEP_SECONDS);
            at = end;
        }
        rig.command(CLOSE, 1).reconnect();

        assertAnswersAHandshake(rig);
    }

    private static void assertAnswersAHandshake(Rig rig) {
        rig.step(RESTART_S).line.take();
        rig.robot.received(rig.line, HANDSHAKE);

        assertThat(rig.line.take()).hasSize(3);
        assertThat(rig.command(1, 1).step(0.3).sips()).hasSizeGreaterThanOrEqualTo(2);
    }

    private static List<String> decode(PacketReader reader, byte[] wire, int chunkSize) {
        List<String> packets = new ArrayList<>();
        for (int at = 0; at < wire.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize));
            reader.feed(chunk).forEach(packet -> packets.add(packet.id() + HEX.formatHex(packet.data())));
        }
        return packets;
    }
}

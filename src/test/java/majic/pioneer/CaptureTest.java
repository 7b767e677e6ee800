package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Collectors;
import majic.bot.Pose;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Models;
import majic.pioneer.state.StateTracker;
import org.junit.jupiter.api.Test;

/** A whole session of the maker's client with the maker's simulator, where the captures are available. */
class CaptureTest {
    private static final Path CAPTURE = Path.of(System.getProperty("majic.captures", ""), "arcos-aria-java.log");

    @Test
    void everyByteTheRobotSentBelongsToAPacket() throws IOException {
        FrameDecoder decoder = new FrameDecoder();
        List<Packet> packets = decode(decoder, "R<");

        assertThat(decoder.counts()).isEqualTo(new PacketCounts(packets.size(), 0, 0));
        assertThat(packets).filteredOn(Packet::isSip).hasSizeGreaterThan(60).allMatch(sip -> Sip.decode(sip) != null);
    }

    @Test
    void everyByteTheClientSentBelongsToAPacket() throws IOException {
        FrameDecoder decoder = new FrameDecoder();

        assertThat(decode(decoder, "C>")).hasSizeGreaterThan(30);
        assertThat(decoder.counts().skippedBytes()).isZero();
    }

    @Test
    void ourCommandsAreByteForByteTheMakersClients() throws IOException {
        Map<Integer, ArcosCommand> commands = Arrays.stream(ArcosCommand.values())
                .collect(Collectors.toMap(ArcosCommand::number, Function.identity()));
        for (Packet packet : decode(new FrameDecoder(), "C>")) {
            byte[] data = packet.data();
            if (data.length == 3) {
                int magnitude = data[1] & 0xFF | (data[2] & 0xFF) << 8;
                byte[] ours = commands.get(packet.type())
                        .packet(data[0] == 0x1B ? -magnitude : magnitude)
                        .bytes();
                assertThat(Bytes.hex(ours)).isEqualTo(Bytes.hex(Bytes.wire(packet.type(), data)));
            }
        }
    }

    @Test
    void theRobotIsTrackedWithoutAJump() throws IOException {
        StateTracker tracker = new StateTracker(Models.of("p3dx"), Pose.START);
        Pose before = Pose.START;
        long nanos = 0;
        for (Packet packet : decode(new FrameDecoder(), "R<")) {
            if (packet.isSip()) {
                nanos += 100_000_000;
                Pose now = tracker.track(Objects.requireNonNull(Sip.decode(packet)), nanos)
                        .pose();
                assertThat(now.distanceMm(before)).isLessThan(60);
                before = now;
            }
        }
        assertThat(before.xMm()).isGreaterThan(500);
    }

    private static List<Packet> decode(FrameDecoder decoder, String direction) throws IOException {
        assumeThat(CAPTURE).exists();
        List<Packet> packets = new ArrayList<>();
        for (String line : Files.readAllLines(CAPTURE)) {
            String[] parts = line.split(" ");
            if (parts.length == 3 && parts[1].equals(direction) && !parts[2].equals("EOF")) {
                byte[] chunk = Bytes.of(parts[2]);
                decoder.feed(chunk, chunk.length, packets::add);
            }
        }
        return packets;
    }
}

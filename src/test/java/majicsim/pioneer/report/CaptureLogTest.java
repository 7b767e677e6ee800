package majicsim.pioneer.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.pioneer.model.Generation;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.Packet;
import majicsim.pioneer.packet.PacketReader;
import majicsim.pioneer.ranging.SonarReading;
import majicsim.pioneer.session.Command;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A whole session of the vendor's client with the vendor's simulator, where the folder of captures is at hand. */
class CaptureLogTest {
    private final List<String> lines = new ArrayList<>();

    @BeforeEach
    void read() throws IOException {
        String folder = System.getProperty("majic.captures", "");
        Path log = Path.of(folder, "arcos-aria-java.log");
        Assumptions.assumeTrue(!folder.isEmpty() && Files.exists(log), "no captures given");
        lines.addAll(Files.readAllLines(log));
    }

    @Test
    void everythingTheClientSentIsUnderstood() {
        PacketReader reader = new PacketReader();
        List<Packet> packets = reader.feed(said("C>"));
        assertThat(packets).hasSizeGreaterThan(80);
        assertThat(packets).allMatch(packet -> Command.of(packet.id()).isPresent());
        assertThat(reader.skippedBytes()).isZero();
    }

    @Test
    void everySipIsEncodedAgainByteForByte() {
        List<Packet> packets = new PacketReader().feed(said("R<"));
        List<Packet> sips = packets.stream().filter(p -> p.id() == 0x32).toList();
        assertThat(sips).hasSizeGreaterThan(50);
        for (Packet captured : sips) {
            byte[] again = encodedAgain(captured);
            assertThat(Arrays.copyOfRange(again, 4, again.length - 2)).isEqualTo(captured.data());
        }
    }

    @Test
    void aRecordedSessionDrivesTheSimulatedRobotLikeTheRealOne() {
        Rig rig = Rig.silent();
        double labSeconds = 0;
        double start = Double.NaN;
        for (String line : lines.stream().filter(line -> line.contains(" C> ")).toList()) {
            double at = Double.parseDouble(line.substring(0, line.indexOf(' ')));
            start = Double.isNaN(start) ? at : start;
            for (; labSeconds < at - start; labSeconds += 0.1) {
                rig.step(0.1);
            }
            rig.send(line.substring(line.indexOf("C>") + 2));
        }
        List<SipView> sips = rig.sips();
        assertThat(sips).extracting(SipView::left).contains(30, 60, 90, 250);
        assertThat(sips.get(sips.size() - 1).headingDeg()).isBetween(85.0, 91.0);
        assertThat(rig.line.isOpen()).isFalse();
    }

    private byte[] said(String who) {
        return lines.stream()
                .filter(line -> line.contains(' ' + who + ' ') && !line.endsWith("EOF"))
                .map(line -> HexFormat.of()
                        .parseHex(line.substring(line.indexOf(who) + 3).strip()))
                .reduce(new byte[0], Hex::concat);
    }

    private static byte[] encodedAgain(Packet captured) {
        SipView view = new SipView(Hex.concat(new byte[] {0, 0, 0, 0x32}, captured.data(), new byte[2]));
        Sip.Motion motion = new Sip.Motion(
                view.x(), view.y(), view.heading(), view.left(), view.right(), view.control(), view.turnRateTenths());
        int stall = view.isStalled() ? 1 : 0;
        Sip.Status status = new Sip.Status(view.battery(), stall, stall, view.flags(), 0);
        SipTail tail = new SipTail(
                Generation.AROS, 0, view.analogPort(), 0, 0xFF, view.digitalOut(), 0, 0, SipTail.NO_TEMPERATURE, 0, 0);
        List<SonarReading> sonar = view.sonar().entrySet().stream()
                .map(reading -> new SonarReading(reading.getKey(), reading.getValue()))
                .toList();
        return new Sip(motion, status, sonar, tail).toBytes();
    }
}

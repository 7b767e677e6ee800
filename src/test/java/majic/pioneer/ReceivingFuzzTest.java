package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import majic.bot.Pose;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.StateTracker;

/**
 * Arbitrary bytes from a robot: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ReceivingFuzzTest {
    private static final Packet GOOD = Bytes.packet(Bytes.TURNING_RIGHT);

    private static final long CYCLE_NANOS = 100_000_000;

    /** Around a packet's data: header, count, type and checksum. */
    private static final int FRAME_BYTES = 6;

    @FuzzTest
    void everyByteIsOneOfAPacketOrSkipped(byte[] wire) {
        FrameDecoder decoder = new FrameDecoder();
        List<Packet> packets = new ArrayList<>();
        decoder.feed(wire, wire.length, packets::add);
        decoder.dropFragment(packets::add);

        int at = 0;
        int packetBytes = 0;
        for (Packet packet : packets) {
            byte[] sent = Bytes.wire(packet.type(), packet.data());
            at = indexOf(wire, sent, at) + sent.length;
            packetBytes += sent.length;
        }
        PacketCounts counts = decoder.counts();
        assertThat(counts.packets()).isEqualTo(packets.size());
        assertThat(counts.skippedBytes()).isEqualTo(wire.length - packetBytes);
    }

    @FuzzTest
    void theSamePacketsComeHoweverTheBytesAreCut(byte[] wire) {
        List<Packet> whole = decode(new FrameDecoder(), wire, wire.length + 1);
        int chunkSize = wire.length == 0 ? 1 : 1 + (wire[wire.length - 1] & 0x3F);

        assertThat(decode(new FrameDecoder(), wire, chunkSize)).isEqualTo(whole);
        assertThat(decode(new FrameDecoder(), wire, 1)).isEqualTo(whole);
    }

    @FuzzTest
    void aGoodPacketIsFoundAfterAnyNoiseAndASilence(byte[] noise) {
        FrameDecoder decoder = new FrameDecoder();
        decode(decoder, noise, noise.length + 1);
        decoder.dropFragment(packet -> {});

        assertThat(decode(decoder, Bytes.of(Bytes.TURNING_RIGHT), 16)).containsExactly(GOOD);
    }

    /** The noise may end in a header that waits for 255 bytes, so it can swallow three packets, never a fourth. */
    @FuzzTest
    void aGoodPacketIsFoundAfterAnyNoiseWithoutASilence(byte[] noise) {
        FrameDecoder decoder = new FrameDecoder();
        decode(decoder, noise, noise.length + 1);
        String four = Bytes.TURNING_RIGHT.repeat(4);

        assertThat(decode(decoder, Bytes.of(four), 16)).endsWith(GOOD);
    }

    @FuzzTest
    void noPacketBreaksTheDriver(byte[] plan) {
        StateTracker tracker = new StateTracker(Models.of("p3dx"), Pose.START);
        PioneerState state = tracker.track(Objects.requireNonNull(Sip.decode(GOOD)), CYCLE_NANOS);
        for (Packet packet : decode(new FrameDecoder(), packets(plan), 512)) {
            assertThat(Config.decode(packet).frontBumpers()).isNotNegative();
            Report report = ReportKind.decode(packet);
            if (report != null) {
                tracker.add(report);
            }
            state = Objects.requireNonNull(tracker.last());
            Sip sip = Sip.decode(packet);
            state = sip == null ? state : tracker.track(sip, state.atNanos() + CYCLE_NANOS);
            assertMeansSomething(state);
        }
    }

    private static void assertMeansSomething(PioneerState state) {
        assertThat(state.pose().xMm()).isFinite();
        assertThat(state.gaps().values()).allMatch(gap -> gap >= 0);
        assertThat(state.power().volts()).isNotNegative();
        assertThat(state.power().percent().orElse(0)).isBetween(0, 100);
        assertThat(state.ports().allAnalogVolts()).allMatch(Double::isFinite);
        assertThat(state.gyroDegPerSec().orElse(0)).isFinite();
        assertThat(state.encoders()).isNotNull();
        assertThat(state.joystick()).isNotNull();
        assertThat(state.gripper()).isNotNull();
    }

    /** Reads a length, a type and that much data again and again, and frames them. */
    private static byte[] packets(byte[] plan) {
        ByteArrayOutputStream wire = new ByteArrayOutputStream();
        int at = 0;
        while (at + 2 <= plan.length) {
            int end = Math.min(at + 2 + (plan[at] & 0xFF) % (256 - FRAME_BYTES), plan.length);
            wire.writeBytes(Bytes.wire(plan[at + 1] & 0xFF, Arrays.copyOfRange(plan, at + 2, end)));
            at = end;
        }
        return wire.toByteArray();
    }

    private static List<Packet> decode(FrameDecoder decoder, byte[] wire, int chunkSize) {
        List<Packet> packets = new ArrayList<>();
        for (int at = 0; at < wire.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize));
            decoder.feed(chunk, chunk.length, packets::add);
        }
        return packets;
    }

    private static int indexOf(byte[] wire, byte[] sent, int from) {
        for (int at = from; at + sent.length <= wire.length; at++) {
            if (Arrays.equals(wire, at, at + sent.length, sent, 0, sent.length)) {
                return at;
            }
        }
        throw new AssertionError("was never sent: " + Bytes.hex(sent));
    }
}

package majic.mavlink.frame;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Arbitrary bytes from a vehicle: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class FramesFuzzTest {
    private static List<MavlinkFrame> decoded(MavlinkDecoder decoder, byte[] wire, int chunk) {
        List<MavlinkFrame> frames = new ArrayList<>();
        for (int start = 0; start < wire.length; start += chunk) {
            byte[] part = Arrays.copyOfRange(wire, start, Math.min(wire.length, start + chunk));
            decoder.decode(part, part.length, frames::add);
        }
        return frames;
    }

    @FuzzTest
    void theSameFramesComeHoweverTheBytesAreCut(byte[] wire) {
        int chunk = wire.length == 0 ? 1 : 1 + (wire[wire.length - 1] & 0x3F);
        MavlinkDecoder cut = new MavlinkDecoder();
        MavlinkDecoder whole = new MavlinkDecoder();

        assertThat(decoded(cut, wire, chunk)).isEqualTo(decoded(whole, wire, wire.length + 1));
        assertThat(cut.counts()).isEqualTo(whole.counts());
    }

    @FuzzTest
    void aFrameBehindAnythingIsFoundInTime(byte[] wire) {
        byte[] good = MavlinkEncoder.encode(new OutgoingMessage(MavlinkMessageType.ATTITUDE), 2, 0);
        MavlinkDecoder decoder = new MavlinkDecoder();
        decoded(decoder, wire, wire.length + 1);
        List<MavlinkFrame> found = new ArrayList<>();

        // What came before may claim up to 300 bytes, and a message that cannot be checked as many again.
        for (int times = 0; times < 60 && found.isEmpty(); times++) {
            decoder.decode(good, good.length, found::add);
        }

        assertThat(found).isNotEmpty();
    }
}

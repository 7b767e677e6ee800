package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FrameDecoderTest {
    private static final String NOISE = "57 4D 53 32 0D FB 00 FA 12";
    private static final String WRONG_CHECKSUM = "FA FB 06 0B 3B FA 00 05 3C";

    private final FrameDecoder decoder = new FrameDecoder();
    private final List<Packet> found = new ArrayList<>();

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64, 1000})
    void findsTheSamePacketsHoweverTheBytesArrive(int chunkSize) {
        feed(
                chunkSize,
                Bytes.joined(NOISE, Bytes.AT_REST, WRONG_CHECKSUM, Bytes.CONFIG, "FA", Bytes.NAMES, Bytes.STALLED));

        assertThat(found)
                .containsExactly(
                        Bytes.packet(Bytes.AT_REST),
                        Bytes.packet(Bytes.CONFIG),
                        Bytes.packet(Bytes.NAMES),
                        Bytes.packet(Bytes.STALLED));
        assertThat(decoder.counts().damagedPackets()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 5, 1000})
    void findsThePacketInsideADamagedOne(int chunkSize) {
        feed(chunkSize, Bytes.joined("FA FB 20 32 01 02", Bytes.NAMES, Bytes.AT_REST));

        assertThat(found).containsExactly(Bytes.packet(Bytes.NAMES), Bytes.packet(Bytes.AT_REST));
    }

    @Test
    void headersInsideDataAreData() {
        String xIsMinus1030 =
                Bytes.hex(Packet.ofString(0x32, Bytes.of("FA FB 03 00 00 00")).bytes());
        feed(4, Bytes.joined(xIsMinus1030));

        assertThat(found).hasSize(1);
        assertThat(found.get(0).type()).isEqualTo(0x32);
    }

    @ParameterizedTest
    @ValueSource(strings = {"FA FB 00", "FA FB 01 00", "FA FB 02 00 00"})
    void countsThatAreTooSmallAreNoise(String tooSmall) {
        feed(1, Bytes.joined(tooSmall, "FA FB 03 01 00 01"));

        assertThat(found).extracting(Packet::type).containsExactly(1);
    }

    @Test
    void aDroppedFragmentGivesUpThePacketsInIt() {
        feed(1000, Bytes.joined("FA FB FF 32", "FA FB 03 00 00 00"));
        assertThat(found).isEmpty();

        decoder.dropFragment(found::add);

        assertThat(found).extracting(Packet::type).containsExactly(0);
    }

    @Test
    void nothingOfADroppedFragmentSwallowsWhatComesNext() {
        feed(1000, Bytes.of("FA FB FF 32 FA FB FE 32 FA"));
        decoder.dropFragment(found::add);

        feed(1000, Bytes.of(Bytes.AT_REST));

        assertThat(found).containsExactly(Bytes.packet(Bytes.AT_REST));
    }

    @Test
    void aHeaderMayFollowALoneFirstHalf() {
        feed(1000, Bytes.of("FA FA FB 03 01 00 01"));

        assertThat(found).extracting(Packet::type).containsExactly(1);
    }

    @Test
    void theLongestPossiblePacketIsDecoded() {
        byte[] longest = Bytes.of("FA FB FF 32" + " 00".repeat(252) + " 32 00");
        feed(100, longest);

        assertThat(found).extracting(packet -> packet.data().length).containsExactly(252);
    }

    @Test
    void packetsAndDamagedBytesAreCounted() {
        feed(10, Bytes.joined(Bytes.AT_REST, WRONG_CHECKSUM, "00 01", Bytes.STALLED));

        assertThat(decoder.counts()).isEqualTo(new PacketCounts(2, 1, 11));
    }

    @Test
    void longStretchesOfNoiseAreSkippedAndCounted() {
        byte[] zeros = new byte[5000];
        feed(700, zeros);
        feed(700, Bytes.of("FA FB 03 02 00 02"));

        assertThat(found).hasSize(1);
        assertThat(decoder.counts().skippedBytes()).isEqualTo(5000);
    }

    private void feed(int chunkSize, byte[] wire) {
        for (int at = 0; at < wire.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize));
            decoder.feed(chunk, chunk.length, found::add);
        }
    }
}

package majic.pioneer.arcos;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LaserChunkTest {
    /** x 300, y -2, heading 90; readings 32 to 34 of 181. */
    private static final String WITH_POSE = "2C 01 FE FF 5A 00  B5 00 20 00 03  74 13 73 13 00 7D";

    /** Readings 2 and 3 of 4 of laser 1, with reflectances. */
    private static final String WITH_REFLECTANCE = "04 00 02 00 02  74 13 05 00 00  FF FF 20 00 00  01 00";

    @Test
    void aPacketWithThePoseHasItsReadingsBehindIt() {
        LaserChunk chunk = decode(0x60, WITH_POSE);

        assertThat(List.of(chunk.laser(), chunk.total(), chunk.first(), chunk.end()))
                .containsExactly(0, 181, 32, 35);
        assertThat(ranges(chunk)).containsExactly(4980, 4979, 32_000);
    }

    @Test
    void aPacketWithReflectancesHasThemBehindEachReading() {
        LaserChunk chunk = decode(0x61, WITH_REFLECTANCE);

        assertThat(List.of(chunk.laser(), chunk.total(), chunk.first(), chunk.end()))
                .containsExactly(1, 4, 2, 4);
        assertThat(ranges(chunk)).containsExactly(4980, 65_535);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 5, 10, 11, 16})
    void aPacketTooShortForItsReadingsIsNone(int length) {
        byte[] whole = Bytes.of(WITH_POSE);

        assertThat(LaserChunk.decode(packet(0x60, Arrays.copyOf(whole, length))))
                .isNull();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"03 00 00 00 00", "01 00 00 00 02 01 00 02 00", "02 00 02 00 01 01 00", "FF FF 00 00 01 01 00"})
    void aPacketWhoseReadingsAreNotInItsScanIsNone(String readings) {
        assertThat(LaserChunk.decode(packet(0x60, Bytes.of("00 00 00 00 00 00" + readings))))
                .isNull();
    }

    @Test
    void packetsOfOtherTypesAreNone() {
        assertThat(LaserChunk.decode(packet(0x62, Bytes.of(WITH_POSE)))).isNull();
    }

    private static LaserChunk decode(int type, String data) {
        return Objects.requireNonNull(LaserChunk.decode(packet(type, Bytes.of(data))));
    }

    private static Packet packet(int type, byte[] data) {
        return Bytes.packet(Bytes.hex(Bytes.wire(type, data)));
    }

    private static List<Integer> ranges(LaserChunk chunk) {
        return IntStream.range(chunk.first(), chunk.end())
                .mapToObj(chunk::rangeMm)
                .toList();
    }
}

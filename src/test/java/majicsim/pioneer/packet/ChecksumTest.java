package majicsim.pioneer.packet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ChecksumTest {
    @ParameterizedTest
    @CsvSource({
        "043B0100, 053B",
        "EE2B026869, F0FA",
        "01, 0001",
        "0B3BFA00, 053B",
        "90 00F40100 0006FFFF, 8BFF",
    })
    void agreesWithTheExamplesOfTheSheet(String content, String sum) {
        byte[] bytes = Hex.bytes(content);
        assertThat(Checksum.of(bytes, 0, bytes.length)).isEqualTo(Integer.parseInt(sum, 16));
    }
}

package majicsim.pioneer.packet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ArgumentTest {
    @ParameterizedTest
    @CsvSource({"3B FA 00, 250", "1B C8 00, -200", "3B 00 80, 32768", "3B, 0", "'', 0", "1B 05, -5", "3B 01 00 FF, 1"})
    void aNumberIsASignAndAMagnitudeAndMissingBytesAreZero(String hex, int value) {
        assertThat(argument(hex).integer()).isEqualTo(value);
    }

    @ParameterizedTest
    @CsvSource({"3B 0A 05, 5, 10", "1B F6 04, -5, 10", "3B 0A FB, -5, 10"})
    void bothFormsOfTwoPackedBytesDecodeAlike(String hex, int left, int right) {
        assertThat(argument(hex).highByte()).isEqualTo(left);
        assertThat(argument(hex).lowByte()).isEqualTo(right);
    }

    @ParameterizedTest
    @CsvSource({"2B 02 68 69, hi", "2B 02 68 69 00, hi", "2B 09 68 69, hi", "2B, ''", "'', ''"})
    void aStringEndsByItsLengthOrWithThePacket(String hex, String text) {
        assertThat(argument(hex).text()).isEqualTo(text);
    }

    @Test
    void longNumbersFollowAnyTypeByte() {
        Argument pose = argument("3B 60 F0 FF FF 48 F4 FF FF 2D 00 00 00");
        assertThat(new int[] {pose.int32(0), pose.int32(1), pose.int32(2)}).containsExactly(-4000, -3000, 45);
    }

    private static Argument argument(String hex) {
        return new Argument(Hex.bytes(hex));
    }
}

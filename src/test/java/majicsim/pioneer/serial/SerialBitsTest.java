package majicsim.pioneer.serial;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.PacketReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SerialBitsTest {
    private static final byte[] SYNC0 = Hex.bytes("FA FB 03 00 00 00");

    @Test
    void endsWithTheSameSpeedReadTheSameBytes() {
        assertThat(SerialBits.heard(SYNC0, 38_400, 38_400)).isEqualTo(SYNC0);
    }

    @Test
    void aLittleDifferenceDoesNotMatter() {
        assertThat(SerialBits.heard(SYNC0, 9600, 9500)).isEqualTo(SYNC0);
        assertThat(SerialBits.heard(SYNC0, 9600, 9700)).isEqualTo(SYNC0);
    }

    @ParameterizedTest
    @CsvSource({"9600,19200", "9600,38400", "9600,57600", "9600,115200", "38400,9600", "115200,9600", "57600,38400"})
    void endsAtDifferentSpeedsReceiveRubbish(int sentBaud, int readBaud) {
        byte[] heard = SerialBits.heard(SYNC0, sentBaud, readBaud);
        assertThat(heard).isNotEqualTo(SYNC0);
        assertThat(new PacketReader().feed(heard)).isEmpty();
    }

    @Test
    void aFasterReaderSeesMoreBytesAndASlowerOneFewer() {
        assertThat(SerialBits.heard(SYNC0, 9600, 38_400)).hasSizeGreaterThan(SYNC0.length);
        assertThat(SerialBits.heard(SYNC0, 38_400, 9600)).hasSizeLessThan(SYNC0.length);
    }

    @Test
    void atTwiceTheSpeedEachBitIsReadTwice() {
        assertThat(SerialBits.heard(new byte[] {0x0F}, 9600, 19_200)).startsWith((byte) 0xFE);
    }

    @Test
    void nothingSentIsNothingReceived() {
        assertThat(SerialBits.heard(new byte[0], 9600, 38_400)).isEmpty();
    }
}

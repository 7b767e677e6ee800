package majic.aibo.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioFormat.Encoding;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import majic.bot.BotException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class WaveFileTest {
    @ParameterizedTest
    @CsvSource({
        "8, PCM_UNSIGNED, C000",
        "16, PCM_SIGNED, 00400080",
        "24, PCM_SIGNED, 000040000080",
        "32, PCM_SIGNED, 0000004000000080",
        "32, PCM_FLOAT, 0000003F000080BF"
    })
    void halfUpAndFullDownAreThoseInEveryLayout(int bits, String encoding, String hex) {
        AudioFormat format = new AudioFormat(new Encoding(encoding), 8000, bits, 1, bits / 8, 8000, false);

        Pcm sound = WaveFile.read("x.wav", Sounds.wav(format, bytes(hex)));

        assertThat(sound.mono()).containsExactly(new double[] {0.5, -1}, within(1e-6));
        assertThat(sound.seconds()).isEqualTo(2 / 8000.0);
    }

    @Test
    void channelsAreMixed() {
        AudioFormat stereo = new AudioFormat(44_100, 16, 2, true, false);

        Pcm sound = WaveFile.read("x.wav", Sounds.wav(stereo, bytes("0040004000C00040")));

        assertThat(sound.mono()).containsExactly(new double[] {0.5, 0}, within(1e-6));
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 0, -1, 1000})
    void aWrongLengthIsLimitedToTheFile(int said) {
        byte[] file = Sounds.riff(
                Sounds.chunk("LIST", 3, new byte[4]),
                Sounds.format(1, 16_000, 16),
                Sounds.chunk("data", said, bytes("00400040")));

        assertThat(WaveFile.read("x.wav", file).frames()).isEqualTo(2);
    }

    @Test
    void aFileThatCannotBePlayedIsRefusedWithTheReason() {
        byte[] silence = Sounds.chunk("data", 4, new byte[4]);

        refused("x.wav: not a WAV file", "ID3 this is a song".getBytes(StandardCharsets.US_ASCII));
        refused("x.wav: not a WAV file");
        refused("x.wav: a WAV file without sound in it", Sounds.riff(Sounds.format(1, 8000, 8)));
        refused("x.wav: a damaged WAV file; its header is not whole", Sounds.riff(silence));
        refused(
                "x.wav: its sound is compressed (WAV format 7); save it as PCM, of 16 bits for instance",
                Sounds.riff(Sounds.format(7, 8000, 8), silence));
        refused(
                "x.wav: a WAV file of 1 channel(s), 0 Hz and 16 bits cannot be played; 16 bits and 16000 Hz are what the "
                        + "dog has",
                Sounds.riff(Sounds.format(1, 0, 16), silence));
    }

    @Test
    void aDamagedFileIsReadOrRefused() {
        byte[] whole = Sounds.wav(8000, 0.1);
        Random random = new Random(4);
        for (int round = 0; round < 20_000; round++) {
            byte[] damaged = Arrays.copyOf(whole, random.nextInt(whole.length + 1));
            for (int hit = random.nextInt(6); hit > 0 && damaged.length > 0; hit--) {
                damaged[random.nextInt(Math.min(60, damaged.length))] = (byte) random.nextInt();
            }
            readOrRefused(damaged);
        }
    }

    private static void readOrRefused(byte[] file) {
        try {
            Pcm sound = WaveFile.read("x.wav", file);
            assertThat(sound.frames()).isPositive();
            assertThat(SpeakerSound.of(sound).length()).isPositive();
        } catch (BotException e) {
            assertThat(e).hasMessageStartingWith("x.wav: ");
        }
    }

    @Test
    void aWrittenFileIsReadByTheJavaLibrary() throws Exception {
        PcmFormat stereo = new PcmFormat(2, 16_000, 16, PcmFormat.Coding.SIGNED);
        byte[] bytes = bytes("0100FF7F00800200");

        byte[] file = WaveFile.write(new Pcm(stereo, bytes));

        try (AudioInputStream read = AudioSystem.getAudioInputStream(new ByteArrayInputStream(file))) {
            assertThat(read.getFormat().toString()).startsWith("PCM_SIGNED 16000.0 Hz, 16 bit, stereo, 4 bytes/frame");
            assertThat(read.readAllBytes()).isEqualTo(bytes);
        }
        assertThat(ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).getInt(4))
                .isEqualTo(file.length - 8);
    }

    private static void refused(String message, byte... file) {
        assertThatThrownBy(() -> WaveFile.read("x.wav", file))
                .isInstanceOf(BotException.class)
                .hasMessage(message);
    }

    private static byte[] bytes(String hex) {
        return HexFormat.of().parseHex(hex);
    }
}

package majic.aibo.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import majic.aibo.urbi.UrbiConnection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SpeakerSoundTest {
    private static final int LARGEST_PIECE_BYTES = 24_000;

    @ParameterizedTest
    @ValueSource(ints = {8000, 11_025, 16_000, 22_050, 44_100, 48_000, 192_000})
    void everyRateBecomesThatOfTheSpeaker(int rateHz) {
        SpeakerSound sound = SpeakerSound.of(tone(rateHz, 440, 0.5));

        assertThat(sound.seconds()).isCloseTo(0.5, within(0.001));
        assertThat(crossings(sound)).isCloseTo(440, within(3L));
        assertThat(loudest(sound)).isCloseTo(16_000, within(200));
    }

    @Test
    void aToneAboveTheRangeOfTheSpeakerIsFilteredOut() {
        assertThat(loudest(SpeakerSound.of(tone(96_000, 31_000, 0.2)))).isLessThan(4000);
    }

    @Test
    void soundInTheFormatOfTheSpeakerIsSentUnchanged() {
        Pcm sound = new Pcm(format(16_000), HexFormat.of().parseHex("0000FF7F01800100"));

        assertThat(SpeakerSound.of(sound).bytes(0, 4, 1)).isEqualTo(sound.bytes());
        assertThat(SpeakerSound.of(sound).bytes(0, 4, 0.5))
                .inHexadecimal()
                .isEqualTo(HexFormat.of().parseHex("0000004000C00000"));
    }

    @Test
    void theSoundIsSplitIntoPiecesThatFitIntoTheQueueOfTheServer() {
        SpeakerSound sound = SpeakerSound.of(tone(16_000, 440, 3.1));

        List<Integer> ends = ends(sound);

        int from = 0;
        for (int end : ends) {
            assertThat(2 * (end - from)).isBetween(2, LARGEST_PIECE_BYTES);
            from = end;
        }
        assertThat(from).isEqualTo(sound.length());
        assertThat(LARGEST_PIECE_BYTES).isLessThanOrEqualTo(UrbiConnection.LARGEST_BINARY);
    }

    @Test
    void aPieceEndsWhereItIsQuiet() {
        Pcm loud = tone(16_000, 440, 2);
        Arrays.fill(loud.bytes(), 2 * 9500, 2 * 9900, (byte) 0);

        assertThat(ends(SpeakerSound.of(loud)).get(0)).isBetween(9500, 9900);
    }

    @Test
    void theShortestSoundIsOneSample() {
        assertThat(SpeakerSound.of(new Pcm(format(192_000), new byte[2])).length())
                .isEqualTo(1);
    }

    private static List<Integer> ends(SpeakerSound sound) {
        List<Integer> ends = new ArrayList<>();
        for (int from = 0; from < sound.length(); from = ends.get(ends.size() - 1)) {
            ends.add(sound.endOfPiece(from));
        }
        return ends;
    }

    private static PcmFormat format(int rateHz) {
        return new PcmFormat(1, rateHz, 16, PcmFormat.Coding.SIGNED);
    }

    private static Pcm tone(int rateHz, double hertz, double seconds) {
        byte[] bytes = new byte[2 * (int) (rateHz * seconds)];
        for (int index = 0; index < bytes.length / 2; index++) {
            Pcm.put(bytes, 2 * index, (short) (16_000 * Math.sin(2 * Math.PI * hertz * index / rateHz)));
        }
        return new Pcm(format(rateHz), bytes);
    }

    private static short sample(SpeakerSound sound, int index) {
        byte[] bytes = sound.bytes(index, index + 1, 1);
        return (short) (bytes[0] & 0xFF | bytes[1] << 8);
    }

    private static int loudest(SpeakerSound sound) {
        int loudest = 0;
        for (int index = 0; index < sound.length(); index++) {
            loudest = Math.max(loudest, Math.abs(sample(sound, index)));
        }
        return loudest;
    }

    private static long crossings(SpeakerSound sound) {
        long crossings = 0;
        for (int index = 1; index < sound.length(); index++) {
            crossings += sample(sound, index) >= 0 == sample(sound, index - 1) >= 0 ? 0 : 1;
        }
        return crossings;
    }
}

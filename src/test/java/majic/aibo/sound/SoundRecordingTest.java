package majic.aibo.sound;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SoundRecordingTest {
    private static final int BLOCK = 2048;
    private static final int BLOCK_MS = 32;

    private final AtomicInteger done = new AtomicInteger();
    private final SoundRecording recording = new SoundRecording(1, done::incrementAndGet);

    @Test
    void blocksFollowEachOtherUntilTheTimeIsFull() {
        for (int index = 0; index < 40; index++) {
            block(index * BLOCK_MS, index);
        }

        assertThat(done).hasValue(1);
        assertThat(bytes()).hasSize(64_000);
        assertThat(bytes()[5 * BLOCK]).isEqualTo((byte) 5);
        assertThat(recording.lostMs()).isZero();
    }

    @Test
    void aBlockThatIsMissingLeavesSilence() {
        block(0, 1);
        block(BLOCK_MS, 2);
        block(4 * BLOCK_MS, 3);

        assertThat(bytes()).hasSize(5 * BLOCK);
        assertThat(Arrays.copyOfRange(bytes(), 2 * BLOCK, 4 * BLOCK)).containsOnly(0);
        assertThat(bytes()[4 * BLOCK]).isEqualTo((byte) 3);
        assertThat(recording.lostMs()).isEqualTo(2 * BLOCK_MS);
    }

    @Test
    void aRepeatedOrEarlyBlockIsUsedOnce() {
        block(0, 1);
        block(8, 9);
        block(BLOCK_MS - 10, 2);
        block(BLOCK_MS, 9);
        block(2 * BLOCK_MS + 12, 3);

        assertThat(bytes()).hasSize(3 * BLOCK);
        assertThat(List.of(bytes()[0], bytes()[BLOCK], bytes()[2 * BLOCK]))
                .containsExactly((byte) 1, (byte) 2, (byte) 3);
    }

    @Test
    void aJumpOfTheClockFillsNoMoreThanTheRecordedTime() {
        block(0, 1);
        block(1_000_000_000_000L, 2);

        assertThat(bytes()).hasSize(64_000);
        assertThat(recording.isDone()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"raw 2 16000 16 1 1", "raw 2 16000 16 1", "wav 2 16000 16 1", "wav", "raw"})
    void everyNotationOfTheFormatIsRead(String words) {
        take(0, words, new byte[BLOCK]);

        assertThat(sound().format()).isEqualTo(new PcmFormat(2, 16_000, 16, PcmFormat.Coding.SIGNED));
    }

    @Test
    void aBlockMayBeAWavFileAndMayHaveOtherSamples() {
        take(0, "wav 2 16000 16 1", Sounds.wav(8000, 0.032));
        assertThat(sound().format()).isEqualTo(new PcmFormat(1, 8000, 16, PcmFormat.Coding.SIGNED));

        SoundRecording other = new SoundRecording(1, () -> {});
        other.take(message(0, "raw 1 8000 8 2", HexFormat.of().parseHex("8000FF")));
        assertThat(Objects.requireNonNull(other.sound()).bytes())
                .isEqualTo(HexFormat.of().parseHex("00000080007F"));
    }

    @Test
    void anUnreadableFirstBlockEndsTheRecordingAndALaterOneIsSkipped() {
        block(0, 1);
        take(BLOCK_MS, "raw 0 0 0 0", new byte[7]);
        block(2 * BLOCK_MS, 3);
        assertThat(recording.failure()).isNull();
        assertThat(recording.lostMs()).isEqualTo(BLOCK_MS);

        SoundRecording other = new SoundRecording(1, done::incrementAndGet);
        other.take(message(0, "raw 0 0 0 0", new byte[7]));
        assertThat(other.failure())
                .isEqualTo("the dog's microphone speaks of raw 0 0 0 0 in 7 bytes, which makes no sense");
        assertThat(done).hasValue(1);
    }

    @Test
    void theRefusalOfADogWithoutAMicrophoneIsReported() {
        recording.take(new UrbiMessage(0, "ear", new UrbiMessage.Failure("Unknown identifier: micro.val")));

        assertThat(recording.failure()).isEqualTo("the dog refuses: Unknown identifier: micro.val");
        assertThat(recording.sound()).isNull();
    }

    private void block(long timeMs, int content) {
        byte[] bytes = new byte[BLOCK];
        Arrays.fill(bytes, (byte) content);
        take(timeMs, "raw 2 16000 16 1 1", bytes);
    }

    private void take(long timeMs, String words, byte... bytes) {
        recording.take(message(timeMs, words, bytes));
    }

    private static UrbiMessage message(long timeMs, String words, byte... bytes) {
        UrbiValue block = new UrbiValue.Binary(List.of(words.split(" ")), bytes);
        return new UrbiMessage(timeMs, "ear", new UrbiMessage.Result(block));
    }

    private Pcm sound() {
        return Objects.requireNonNull(recording.sound());
    }

    private byte[] bytes() {
        return sound().bytes();
    }
}

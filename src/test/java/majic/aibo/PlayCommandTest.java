package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import javax.sound.sampled.AudioFormat;
import majic.aibo.sound.Sounds;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionStopped;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PlayCommandTest {
    private static final int SENSORS = 1;

    @TempDir
    Path folder;

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.lying().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void aShortSoundIsOneUntaggedAssignmentWithItsBytesRightBehindIt() throws IOException {
        AudioFormat speakers = new AudioFormat(16_000, 16, 1, true, false);
        byte[] bytes = "\0\1;,\n}\"#".getBytes(StandardCharsets.ISO_8859_1);
        Path file = Files.write(folder.resolve("a.wav"), Sounds.wav(speakers, bytes));

        assertThat(play(file)).endsWith("of sound, sent over");

        assertThat(dog.binaries()).containsExactly(SENSORS + ":speaker.val = BIN 8 raw 1 16000 16 1;\0\1;,\n}\"#");
        assertThat(aibo.get("version")).isEqualTo(Value.text("ERS-7, URBI 1.0"));
    }

    @Test
    void aLongSoundIsSentInPiecesThatFitIntoTheQueueOfTheServer() throws IOException {
        byte[] wav = Sounds.wav(16_000, 1.2);
        play(Files.write(folder.resolve("a.wav"), wav));

        List<String> pieces = dog.binaries();

        assertThat(pieces).hasSize(2).allMatch(piece -> piece.length() < 32 * 1024);
        String sent = String.join(
                "",
                pieces.stream()
                        .map(piece -> piece.substring(piece.indexOf(';') + 1))
                        .toList());
        assertThat(sent.getBytes(StandardCharsets.ISO_8859_1)).isEqualTo(Arrays.copyOfRange(wav, 44, wav.length));
    }

    @Test
    void theNextPieceWaitsForTheEndOfTheOneThatPlays() throws IOException {
        dog.set("speaker.remain", "40.000000");
        Path file = Files.write(folder.resolve("a.wav"), Sounds.wav(16_000, 0.01));
        CompletableFuture<String> playing = dog.clock().aside(() -> play(file));
        until(() -> dog.received("speaker.remain").size() > 5);
        assertThat(dog.binaries()).isEmpty();

        dog.set("speaker.remain", "0.000000");

        assertThat(dog.clock().join(playing)).isNotEmpty();
        assertThat(dog.binaries()).hasSize(1);
    }

    @Test
    void aStopEndsItAndOnlyOneSoundIsPlayedAtATime() throws IOException {
        Path file = Files.write(folder.resolve("a.wav"), Sounds.wav(16_000, 50));
        CompletableFuture<String> playing = dog.clock().aside(() -> play(file));
        until(() -> !dog.binaries().isEmpty());
        assertThatThrownBy(() -> play(file)).hasMessageContaining("another sound is being played");

        aibo.stop();

        assertThatThrownBy(() -> dog.clock().join(playing)).hasCauseInstanceOf(MotionStopped.class);
        assertThat(dog.binaries()).hasSize(1);
    }

    @Test
    void aLostConnectionEndsTheSound() throws IOException {
        Path file = Files.write(folder.resolve("a.wav"), Sounds.wav(16_000, 50));
        CompletableFuture<String> playing = dog.clock().aside(() -> play(file));
        until(() -> !dog.binaries().isEmpty());

        dog.hangUp();

        assertThatThrownBy(() -> dog.clock().join(playing)).hasCauseInstanceOf(LinkLost.class);
    }

    @Test
    void withoutReportsOfTheSpeakerThePlayingTimeIsEstimated() throws IOException {
        dog.set("speaker.remain", "!!! Unknown identifier: speaker.remain");
        play(Files.write(folder.resolve("a.wav"), Sounds.wav(16_000, 0.8)));

        assertThat(dog.binaries()).hasSize(2);
    }

    @Test
    void aRefusalOfTheServerIsReported() throws IOException {
        dog.set("speaker.remain", "!!! Receive buffer full");
        Path file = Files.write(folder.resolve("a.wav"), Sounds.wav(16_000, 0.01));

        assertThatThrownBy(() -> play(file))
                .isInstanceOf(BotException.class)
                .hasMessage("the dog refuses: Receive buffer full");
    }

    @Test
    void aFileThatCannotBePlayedIsRefusedBeforeAnythingIsSent() throws IOException {
        Path file = Files.writeString(folder.resolve("a.wav"), "not a sound");
        Path slow = Files.write(folder.resolve("b.wav"), Sounds.wav(1000, 60.5));

        assertThatThrownBy(() -> play(file)).hasMessage(file + ": not a WAV file");
        assertThatThrownBy(() -> play(slow)).hasMessage(slow + ": lasts 60.5 s; 60 s is the most");
        assertThatThrownBy(() -> play(folder)).hasMessage(folder + ": a folder, not a WAV file");
        assertThatThrownBy(() -> play(folder.resolve("c.wav")))
                .hasMessage(folder.resolve("c.wav") + ": there is no such file");
        assertThatThrownBy(() -> aibo.run("play", List.of(Value.text("a\0b"))))
                .hasMessageEndingWith(": no file can have that name");
        assertThat(dog.received("speaker")).isEmpty();
    }

    @Test
    void aFileOfManyMegabytesIsRefusedUnread() throws IOException {
        Path file = folder.resolve("big.wav");
        try (SeekableByteChannel channel =
                Files.newByteChannel(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            channel.position(70 * 1024 * 1024).write(ByteBuffer.allocate(1));
        }

        assertThatThrownBy(() -> play(file))
                .hasMessageEndingWith(": 70 MB are too much for a sound; 64 MB is the most");
    }

    private String play(Path file) {
        return aibo.run("play", List.of(Value.text(file.toString())));
    }

    private void until(BooleanSupplier so) {
        dog.clock().until(so);
    }
}

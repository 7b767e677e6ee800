package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majicsim.aibo.sound.PlayedSound;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what the simulated dog's speaker plays and its microphone records. */
class AiboSoundInLabTest {
    private static final int AMPLITUDE = 8000;

    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final MajicBot dog = rig.add("aibo");

    @TempDir
    Path folder;

    @Test
    void aFileIsPlayedPieceAfterPieceWithNothingLost() throws Exception {
        Path file = tone("hello.wav", 22_050, 2, 2.5);
        theDogsOwnChimesAreOver();

        assertThat(rig.run("1 play \"" + file + "\""))
                .containsExactly("1 play \"" + file + "\": 2.5 s of sound, sent over");

        List<PlayedSound> pieces = sent();
        assertThat(pieces).hasSizeBetween(4, 5);
        assertThat(pieces.stream()
                        .mapToDouble(piece -> piece.sound().lengthMs())
                        .sum())
                .isCloseTo(2500, within(0.5));
        for (int index = 1; index < pieces.size(); index++) {
            PlayedSound former = pieces.get(index - 1);
            assertThat(pieces.get(index).startMs())
                    .isBetween(former.startMs() + former.sound().lengthMs(), former.startMs() + 1000);
        }
        assertThat(loudest(pieces.get(0))).isCloseTo(AMPLITUDE, within(200));
    }

    @Test
    void theVolumeIsThatOfWhatIsSent() throws Exception {
        Path file = tone("hello.wav", 16_000, 1, 0.2);

        rig.run("1 set volume 25", "1 play \"" + file + "\"");

        assertThat(loudest(sent().get(0))).isCloseTo(AMPLITUDE / 4, within(20));
        assertThat(dog.get("volume")).hasToString("25 %");
    }

    @Test
    void aSoundOfTheStickIsPlayedToItsEnd() throws InterruptedException {
        assertThat(rig.run("1 play bark", "1 play BARK2.wav", "1 get playing"))
                .startsWith("1 play bark: bark.wav of the dog's stick");
        assertThat(played()).extracting(PlayedSound::what).contains("bark.wav");
    }

    @Test
    void aMissingSoundIsReported() throws InterruptedException {
        assertThat(rig.run("1 play miaow"))
                .singleElement()
                .asString()
                .startsWith(
                        "1 play miaow: failed: miaow: there is no such file here and no miaow.wav on the dog's stick; a "
                                + "stick as it was sold has bark, bark2, ");
        assertThat(rig.run("1 play \"sounds/miaow.wav\""))
                .singleElement()
                .asString()
                .contains("failed: sounds/miaow.wav: there is no such file");
    }

    @Test
    void aStopEndsASoundBetweenItsPiecesAndTheNextOneMayBegin() throws Exception {
        Path file = tone("long.wav", 8000, 1, 20);
        rig.say("1 play \"" + file + "\"");
        until(() -> sent().size() == 3);

        rig.run("1 stop");

        assertThat(rig.said()).anyMatch(line -> line.endsWith("long.wav\": stopped"));
        assertThat(rig.run("1 play bark")).containsExactly("1 play bark: bark.wav of the dog's stick");
        assertThat(sent()).hasSize(3);
    }

    @Test
    void aDogThatPlaysCanBeStoppedAsFastAsOneThatIsQuiet() throws Exception {
        Path file = tone("long.wav", 16_000, 1, 10);
        rig.say("1 play \"" + file + "\"");
        until(() -> !sent().isEmpty());
        double before = labSeconds();

        dog.stop();

        assertThat(labSeconds() - before).isLessThan(0.1);
    }

    @Test
    void aRecordingIsAFileThatOtherProgramsCanRead() throws Exception {
        Path file = folder.resolve("room.wav");
        theDogsOwnChimesAreOver();
        rig.lab().simulators().besideAibo(handling -> handling.whistle(500, 5000));

        assertThat(rig.run("1 record 1.5 \"" + file + "\""))
                .containsExactly("1 record 1.5 \"" + file + "\": 1.5 s in " + file);

        try (AudioInputStream sound = AudioSystem.getAudioInputStream(file.toFile())) {
            assertThat(sound.getFormat().toString()).startsWith("PCM_SIGNED 16000.0 Hz, 16 bit, stereo");
            assertThat(sound.getFrameLength()).isEqualTo(24_000);
            assertThat(crossings(sound.readAllBytes())).isBetween(1495L, 1505L);
        }
    }

    @Test
    void aRecordingDoesNotReplaceAFile() throws Exception {
        Path file = Files.writeString(folder.resolve("mine.wav"), "mine");

        assertThat(rig.run("1 record 1 \"" + file + "\""))
                .singleElement()
                .asString()
                .endsWith("failed: " + file + ": is there already and is not written over; choose another name");
        assertThat(Files.readString(file)).isEqualTo("mine");
    }

    @Test
    void aStoppedRecordingKeepsWhatItHasAndTheNextOneMayBegin() throws Exception {
        Path file = folder.resolve("room.wav");
        rig.say("1 record 30 \"" + file + "\"");
        double startS = labSeconds();
        until(() -> labSeconds() > startS + 2);

        rig.run("1 stop");

        assertThat(AudioSystem.getAudioFileFormat(file.toFile()).getFrameLength())
                .isBetween(25_000, 35_000);
        assertThat(rig.run("1 record 1 \"" + folder.resolve("next.wav") + "\""))
                .singleElement()
                .asString()
                .contains("1 s in ");
    }

    @Test
    void nothingIsLostOverALinkThatJitters() throws Exception {
        Path file = folder.resolve("room.wav");
        try (LabRig noisy = LabRig.noisy(3)) {
            noisy.add("aibo");

            assertThat(noisy.run("1 record 3 \"" + file + "\""))
                    .containsExactly("1 record 3 \"" + file + "\": 3 s in " + file);
        }
    }

    /** Polls a condition, since the lab sends no notifications. */
    private void until(BooleanSupplier so) throws InterruptedException {
        while (!rig.team().changes().await(so, 0.05)) {
            assertThat(labSeconds()).isLessThan(300);
        }
    }

    /** Waits until the start sounds are over; the dog plays one for each connection. */
    private void theDogsOwnChimesAreOver() throws InterruptedException {
        rig.run("wait 2s");
    }

    private double labSeconds() {
        return rig.lab().time().nanos() / 1e9;
    }

    private Path tone(String name, int rateHz, int channels, double seconds) throws IOException {
        int frames = (int) (rateHz * seconds);
        byte[] bytes = new byte[frames * channels * 2];
        for (int index = 0; index < frames * channels; index++) {
            int sample = (int) (AMPLITUDE * Math.sin(2 * Math.PI * 440 * (index / channels) / rateHz));
            bytes[2 * index] = (byte) sample;
            bytes[2 * index + 1] = (byte) (sample >> 8);
        }
        AudioFormat format = new AudioFormat(rateHz, 16, channels, true, false);
        Path file = folder.resolve(name);
        AudioSystem.write(
                new AudioInputStream(new ByteArrayInputStream(bytes), format, frames),
                AudioFileFormat.Type.WAVE,
                file.toFile());
        return file;
    }

    private List<PlayedSound> played() {
        List<PlayedSound> played = new ArrayList<>();
        rig.lab().simulators().besideAibo(handling -> played.addAll(handling.played()));
        return played;
    }

    private List<PlayedSound> sent() {
        return played().stream().filter(sound -> sound.what().equals("sent")).toList();
    }

    private static int loudest(PlayedSound played) {
        int loudest = 0;
        for (int index = 0; index < played.sound().lengthMs() * 16; index++) {
            loudest = Math.max(loudest, Math.abs(played.sound().sample(index)));
        }
        return loudest;
    }

    /** Returns how often the left channel changes its sign. */
    private static long crossings(byte[] bytes) {
        long crossings = 0;
        boolean above = false;
        for (int at = 0; at < bytes.length; at += 4) {
            boolean now = bytes[at + 1] >= 0;
            crossings += now == above ? 0 : 1;
            above = now;
        }
        return crossings;
    }
}

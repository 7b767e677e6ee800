package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majicsim.aibo.sound.MemoryStickSounds;
import majicsim.aibo.sound.PlayedSound;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Speaker and microphone (URBI sheet, sections 12 and 13). */
class SoundTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @ParameterizedTest
    @CsvSource({"raw 1 8000 8 2, 400, 50", "raw 1 16000 16 1, 3200, 100", "raw 2 16000 16 1, 3200, 50"})
    void aSoundThatIsSentPlaysForItsTimeAndIsKept(String parameters, int bytes, int ms) {
        bench.run(2000);
        client.say("speaker.val = BIN " + bytes + " " + parameters + ";" + "a".repeat(bytes));

        assertThat(client.ask("speaker.playing; speaker.remain;", 0))
                .containsExactly("[notag] 1.000000", "[notag] " + ms + ".000000");
        PlayedSound played = last();
        assertThat(played.what()).isEqualTo("sent");
        assertThat(played.sound().lengthMs()).isEqualTo(ms);
        bench.run(ms + 4);
        assertThat(client.ask("speaker.playing;", 0)).containsExactly("[notag] 0.000000");
    }

    @ParameterizedTest
    @CsvSource({"raw 1 44100 16 1", "raw 1 8000 16 1", "raw 9 16000 16 1", "raw 1", "tune", "wav"})
    void aSoundThatTheSpeakerDoesNotTakeIsSilent(String parameters) {
        int before = bench.dog().handling().played().size();
        client.say("speaker.val = BIN 4 " + parameters + ";abcd");

        assertThat(bench.dog().handling().played()).hasSize(before);
        assertThat(client.ask("1;")).containsExactly("[notag] 1.000000");
    }

    @Test
    void piecesFollowEachOtherWithoutAGap() {
        bench.run(2000);
        client.say("speaker.val = BIN 1600 raw 1 8000 8 1;" + "a".repeat(1600));
        client.say("speaker.val = BIN 800 raw 1 8000 8 1;" + "b".repeat(800));

        assertThat(client.ask("speaker.remain;", 0)).containsExactly("[notag] 300.000000");
        List<PlayedSound> played = bench.dog().handling().played();
        assertThat(last().startMs()).isEqualTo(played.get(played.size() - 2).endMs());
    }

    @Test
    void aFileOfTheStickIsPlayedAndAMissingOneIsNot() {
        assertThat(client.ask("speaker.play(\"bark.wav\"); speaker.play(\"nofile.wav\");"))
                .containsExactly("[notag] 1.000000", "[notag] 0.000000");
        assertThat(last().what()).isEqualTo("bark.wav");
    }

    @Test
    void aFileOfTheStickComesBackAsItIsAfterTheSpeakerPlaysIt() {
        client.say("x = loadwav(\"test.wav\"); speaker.val = x;");

        assertThat(last().sound().lengthMs()).isEqualTo(1000);
        assertThat(last().sound().sample(9))
                .isEqualTo(MemoryStickSounds.named("test").sample(9));
    }

    @Test
    void aConnectionSoundsAChimeAndLightsALamp() {
        assertThat(last().what()).isEqualTo("client.wav");
        assertThat(client.ask("modeB.val;")).containsExactly("[notag] 1.000000");
    }

    @Test
    void theMicrophoneHasTheLast32MillisecondsOfBothEars() {
        bench.run(2000);
        client.say("micro.val;");

        String[] message = client.raw().split("\n", 2);
        assertThat(message[0]).endsWith("BIN 2048 raw 2 16000 16 1 1");
        assertThat(message[1]).isEqualTo("\0".repeat(2048));
    }

    @Test
    void itsMicrophonesRecordItsOwnSpeaker() {
        client.ask("speaker.play(\"test.wav\");", 700);

        assertThat(loudness()).isGreaterThan(5000);
    }

    @Test
    void itsMicrophonesRecordItsWalkAndAWhistleBesideIt() {
        client.ask("motors on; robot.stand(); robot.walk(1000),", 3600);
        double walking = loudness();
        bench.run(1500);
        assertThat(loudness()).isZero();

        bench.dog().handling().whistle(500, 200);
        bench.run(100);

        assertThat(walking).isBetween(100.0, 2000.0);
        assertThat(loudness()).isCloseTo(8000 / Math.sqrt(2), within(300.0));
    }

    @Test
    void aRealEarHisses() {
        Bench real = Bench.noisy(5);
        Bench.Client guest = real.client();
        real.run(2000);

        assertThat(loudness(guest)).isBetween(1.0, 50.0);
    }

    private PlayedSound last() {
        List<PlayedSound> played = bench.dog().handling().played();
        return played.get(played.size() - 1);
    }

    private double loudness() {
        return loudness(client);
    }

    /** Root of the mean square. */
    private static double loudness(Bench.Client client) {
        client.take();
        client.say("micro.val;");
        String bytes = client.raw().split("\n", 2)[1];
        double sum = 0;
        for (int i = 0; i < bytes.length(); i += 2) {
            short sample = (short) (bytes.charAt(i) | bytes.charAt(i + 1) << 8);
            sum += (double) sample * sample;
        }
        return Math.sqrt(sum / (bytes.length() / 2.0));
    }
}

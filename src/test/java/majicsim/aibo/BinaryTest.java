package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** Binary values both ways (URBI sheet, section 12 and appendix A). */
class BinaryTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void theNextMessageFollowsTheBytesWithoutALineEnd() {
        client.say("b=bin 5;hello");
        client.say("b;b;7;");

        assertThat(client.raw().replaceAll("\\d{8}", "t"))
                .isEqualTo("[t:notag] BIN 5\nhello[t:notag] BIN 5\nhello[t:notag] 7.000000\n");
    }

    @Test
    void aBinaryInAListIsFollowedByTheRestOfTheList() {
        client.say("b=bin 5;hello[b,1];");

        assertThat(client.raw().replaceAll("\\d{8}", "t")).isEqualTo("[t:notag] [BIN 5\nhello,1.000000]\n");
    }

    @Test
    void theSpeakerReturnsTheSoundThatItWasGiven() {
        client.say("speaker.val;speaker.val = BIN 4 raw 1 8000 8 1;abcdspeaker.val;");

        assertThat(client.raw().replaceAll("\\d{8}:", "t:")).isEqualTo("[t:notag] BIN 4 raw 1 8000 8 1\nabcd");
    }

    @Test
    void bytesThatLookLikeProgramTextAreTakenAsBytes() {
        for (char c : "speaker.val = BIN 6 raw 1 8000 8 1;1;\"{(#8;".toCharArray()) {
            client.say(String.valueOf(c));
        }

        assertThat(client.take()).containsExactly("[notag] 8.000000");
    }

    @Test
    void aTaggedBinaryIsASyntaxErrorAndItsBytesAreProgramText() {
        assertThat(client.ask("t: speaker.val = BIN 4 raw 1 8000 8 1;9;11;"))
                .containsExactly(
                        "[error] !!! 19.18-20: syntax error, unexpected bin", "[notag] 9.000000", "[notag] 11.000000");
    }

    @Test
    void theCameraGivesAPictureThatCanBeRead() throws IOException {
        client.say("cam: camera.val;");
        String message = client.raw();
        int header = message.indexOf('\n');

        String[] words = message.substring(0, header).split(" ");
        byte[] bytes = message.substring(header + 1).getBytes(StandardCharsets.ISO_8859_1);
        assertThat(words).contains("BIN", "jpeg", "208", "160");
        assertThat(bytes).hasSize(Integer.parseInt(words[2]));
        assertThat(ImageIO.read(new ByteArrayInputStream(bytes)).getWidth()).isEqualTo(208);
    }
}

package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Whatever text comes from a client: found and kept ones in every build, new ones with {@code JAZZER_FUZZ=1} (see
 * CONTRIBUTING.md).
 */
class LanguageFuzzTest {
    /** What opens a string, a comment or a binary would swallow the way out of it too. */
    private static final String SWALLOWING = "[\"#/\\\\bB]";

    @FuzzTest
    void theSameCommandsComeHoweverTheBytesAreCut(byte[] text) {
        List<String> whole = split(text, text.length + 1);
        int chunkSize = text.length == 0 ? 1 : 1 + (text[0] & 0x3F);

        assertThat(split(text, chunkSize)).isEqualTo(whole);
        assertThat(split(text, 1)).isEqualTo(whole);
    }

    @FuzzTest
    void everyCommandIsUnderstoodOrRefusedWithItsPlace(byte[] text) {
        List<String> complaints = new ArrayList<>();

        CommandReader.all(text, complaints::add);

        assertThat(complaints).allMatch(each -> each.matches("(?s)\\d+\\.\\d+.*: .*|Receive buffer .*"));
    }

    @FuzzTest
    void aConnectionLivesOnAfterAnyProgram(byte[] program) {
        Bench bench = Bench.exact();
        Bench.Client client = bench.client();
        Bench.Client other = bench.client();

        String tamed = new String(program, StandardCharsets.ISO_8859_1).replaceAll(SWALLOWING, "c");
        client.ask(tamed, 64);
        client.say("$$;");
        other.ask("stopall;", 64);
        client.take();
        other.take();

        assertThat(other.ask("1;")).contains("[notag] 1.000000");
        if (client.isOpen()) {
            assertThat(client.ask("1;")).contains("[notag] 1.000000");
        }
    }

    private static List<String> split(byte[] text, int chunkSize) {
        Splitter splitter = new Splitter();
        List<String> commands = new ArrayList<>();
        for (int at = 0; at < text.length; at += chunkSize) {
            splitter.feed(Arrays.copyOfRange(text, at, Math.min(text.length, at + chunkSize)));
            for (String next = splitter.next(); next != null; next = splitter.next()) {
                commands.add(next);
            }
        }
        return commands;
    }
}

package majicsim.aibo.urbi.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Whatever text comes from a client: found and kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class LanguageFuzzTest {
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

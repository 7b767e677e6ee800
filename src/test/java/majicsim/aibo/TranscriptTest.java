package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Excerpts of what the real kernel answered: every line, every text, every position must be the same. */
class TranscriptTest {
    @Test
    void answersEveryLineOfTheExcerptsAsTheRealKernel() throws IOException {
        List<Transcript> sessions = Transcript.parse(lines("transcripts.txt"));

        assertThat(sessions).hasSize(6);
        for (Transcript session : sessions) {
            Replay replay = Replay.of(session, sent -> false);
            assertThat(replay.received()).containsExactlyElementsOf(replay.expected());
        }
    }

    @Test
    void cutsTheBytesOfTheExcerptsIntoCommandsAsTheRealKernel() throws IOException {
        List<String> framing = lines("framing.txt");
        Bench.Client client = Bench.exact().client();

        assertThat(framing).hasSize(29);
        for (String line : framing) {
            FramingLine excerpt = FramingLine.parse(line);
            assertThat(String.join("\n", client.ask(excerpt.sent())))
                    .as(excerpt.sent())
                    .isEqualTo(excerpt.received());
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '~',
            quoteCharacter = '`',
            value = {
                "tg: ping; ~ [tg] *** pong time=4064",
                "system.name; ~ [notag] \"ERS-7\"",
                "\"a\"+123456789; ~ [notag] \"a1.23457e+08\"",
                "string(87.6); ~ [notag] \"87\"",
                "loop legRF1 << legRF1.val, ~ [error] !!! 19.14: syntax error, unexpected <",
                "@; ~ [error] !!! 19.1: syntax error, unexpected @, expecting end of command",
                "if 1 2; ~ [error] !!! 19.4: syntax error, unexpected number, expecting (",
                "x = \u00e9 5; ~ [error] !!! 19.5: invalid character: \u00e9",
                "x = \u0000 5; ~ [error] !!! 19.5: invalid character:",
                "group bimotors; ~ [notag] [\"earL\",\"earR\"]",
                "ball.threshold; ~ [notag] 0.001500",
                "ball.load; ~ [notag] 1.000000",
                "headPan.val->rangemin; ~ [notag] -91.000000",
                "group head; ~ [notag] [\"neck\",\"headPan\",\"headTilt\",\"mouth\"]",
                "headTilt'n; ~ [notag] 0.266667",
                "nothing'n; ~ [notag] !!! Unknown identifier: U.nothing",
                "robot.walk(0); 5; ~ [notag] 5.000000",
                "a.b.c: 1; ~ [error] !!! 19.4: syntax error, unexpected ., expecting end of command",
                "q: echo \"a\\\"b\"; ~ [q] *** a\"b"
            })
    void answersOneLineAsInTheSheet(String sent, String received) {
        assertThat(Bench.exact().client().ask(sent).stream().map(Transcript::plain))
                .containsExactly(received);
    }

    @Test
    void aByteThatIsNoCharacterOfTheLanguageCostsItsCommandWithOneError() {
        assertThat(Bench.exact().client().ask("x = \u00e9t\u00e9 5; isdef(x);"))
                .containsExactly("[error] !!! 19.5: invalid character: \u00e9", "[notag] 0.000000");
    }

    @Test
    void theLinesGoOnBehindAnAtSignButNotBehindABracket() {
        assertThat(Bench.exact().client().ask("\n@;\n1 +;").stream().map(Transcript::plain))
                .contains("[error] !!! 21.4: syntax error, unexpected ;");
        assertThat(Bench.exact().client().ask("\n);\n1 +;").stream().map(Transcript::plain))
                .contains("[error] !!! 20.4: syntax error, unexpected ;");
    }

    private static List<String> lines(String resource) throws IOException {
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                Objects.requireNonNull(TranscriptTest.class.getResourceAsStream(resource)), StandardCharsets.UTF_8))) {
            return lines.lines().toList();
        }
    }
}

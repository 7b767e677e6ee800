package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import majic.script.commands.ScriptParser;
import majic.script.syntax.Mistake;
import majic.text.OneSentence;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever is typed is taken or refused with one sentence; nothing is thrown. */
class TokenSoupTest {
    private static final List<String> WORDS = List.of(
            "1",
            "2",
            "1,2",
            "1-4",
            "7",
            "all",
            "any",
            "me",
            "aibo",
            "pioneer",
            "move",
            "turn",
            "drive",
            "stop",
            "get",
            "now",
            "set",
            "log",
            "every",
            "off",
            "act",
            "wait",
            "help",
            "add",
            "sim:aibo",
            "as",
            "remove",
            "bots",
            "probe",
            "release",
            "run",
            "save",
            "session",
            "lab",
            "repeat",
            "while",
            "if",
            "else",
            "end",
            "until",
            "let",
            "print",
            "ask",
            "answer",
            "to",
            "square",
            "$n",
            "-$n",
            "n",
            "+",
            "*",
            "min",
            "max",
            "abs",
            "random",
            "distance",
            "bearing",
            "for",
            "and",
            "or",
            "not",
            "(",
            ")",
            ".",
            ",",
            "<",
            "<=",
            "==",
            "=",
            "!",
            "\"",
            "\"a b\"",
            "#",
            "x",
            "headPan",
            "distanceFront",
            "posture",
            "light",
            "on",
            "yes",
            "clear",
            "sit",
            "near",
            "-3",
            "2.5m",
            "90deg",
            "1e9",
            "99999999999999999999",
            "5%",
            "3s",
            "10ms",
            "-",
            "--",
            "\\",
            "/",
            "é",
            "\u0000",
            "\uD800",
            "\t",
            "wag",
            "𝛑");

    private static String soup(Random random) {
        return IntStream.range(0, 1 + random.nextInt(9))
                .mapToObj(word -> WORDS.get(random.nextInt(WORDS.size())) + (random.nextInt(4) == 0 ? "" : " "))
                .collect(Collectors.joining());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void isAcceptedOrRefusedWithASentence(long seed) {
        Random random = new Random(seed);
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            MajicParser[] parsers = {fixture.prompt, fixture.pipe, MajicParser.socket(fixture.session)};
            for (int line = 0; line < 2000; line++) {
                String text = soup(random);
                Optional<String> wrong = parsers[random.nextInt(3)].parseText(text);
                wrong.ifPresent(sentence ->
                        assertThat(sentence).as(text).isNotBlank().doesNotContain("\n", "Exception", "null"));
                fixture.prompt.complete(text, random.nextInt(text.length() + 1));
            }
        }
    }

    /** Words of expressions, so that more of the lines are accepted, and computed. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void anExpressionIsComputedOrRefusedWithASentence(long seed) throws InterruptedException {
        List<String> words = List.of(
                "1",
                "2.5",
                "30mm",
                "90deg",
                "2s",
                "200mm/s",
                "+",
                "-",
                "*",
                "/",
                "(",
                ")",
                "$n",
                "-$n",
                "min",
                "max",
                "abs",
                "random",
                "distance",
                "1 x",
                "2 heading",
                "clear",
                "yes",
                "\"a b\"",
                "light",
                "1 light",
                "7 x",
                "all x",
                "0");
        Random random = new Random(seed);
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            for (int line = 0; line < 3000; line++) {
                String expression = IntStream.range(0, 1 + random.nextInt(7))
                        .mapToObj(word -> words.get(random.nextInt(words.size())))
                        .collect(Collectors.joining(" "));
                fixture.prompt.parseText("let n = " + expression).ifPresent(OneSentence::check);
                fixture.prompt.parseText("1 set near (" + expression + ")").ifPresent(OneSentence::check);
            }
            fixture.prompt.awaitAll();
            assertThat(fixture.answers()).noneMatch(answer -> answer.contains("internal error"));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "(",
                "not ",
                "1 move 1 until (",
                "1 get x,",
                "if ",
                "repeat\n",
                "1 get x until x < 1 or ",
                "let n = (",
                "let n = - ",
                "print (min ",
                "to a\n"
            })
    void isBoundedInDepthAndLength(String piece) {
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            assertThat(fixture.pipe.parseText("1 move 1 until " + piece.repeat(900)))
                    .isPresent();
            fixture.pipe.parseText(piece.repeat(900));
            List<Mistake> mistakes = mistakesIn(piece.repeat(20_000));
            assertThat(mistakes).isNotEmpty();
        }
    }

    private static List<Mistake> mistakesIn(String text) {
        List<Mistake> mistakes = new ArrayList<>();
        ScriptParser.parse(text, List.of("aibo"), mistakes);
        return mistakes;
    }
}

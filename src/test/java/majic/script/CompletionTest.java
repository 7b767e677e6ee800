package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.script.help.Completion;
import majic.script.help.Completions;
import majic.script.help.VisibleNames;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the Tab key offers. */
class CompletionTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "re | release remove repeat",
                "a | acts add aibo all answer ask",
                "1 mo | move",
                "1,2 w | wag wait",
                "1 bark s | sadly",
                "1.tu | turn",
                "1 get dist | distanceFront",
                "1 get x,volt | voltage",
                "1 set HEAD | headPan",
                "1 set posture s | sit stand",
                "1 set light o | off on",
                "1 move 500 u | until",
                "1 move 500 until near | near",
                "1 move 500 until distanceFront < n | near",
                "1 move 500 until bumped == n | no",
                "1 move 500 until distanceFront < c | clear",
                "1 move 500 until any bu | bumped",
                "1 move 500 until bumped == yes a | and",
                "1 drive 10 10 u | until",
                "if 1 bu | bumped",
                "if any bu | bumped",
                "1.set(posture, s | sit stand",
                "1 drive 10 10 f | for",
                "if 1 bumped == yes o | or",
                "save s | session",
                "add s | sim:aibo sim:pioneer",
                "1 log o | off",
                "help rep | repeat",
                "1 act AiboSquare s | side=",
                "1 act AiboSquare side= | 500mm",
                "1.act(AiboSquare, s | side=",
                "1 act AiboSquare wi | with",
                "2 act Convoy d | distance=",
                "acts Aibo | AiboSquare"
            })
    void fitsThePlace(String text, String words) {
        assertThat(fixture.prompt.complete(text, text.length()).words()).containsExactly(words.split(" "));
    }

    private ScriptRunner runner() {
        return new ScriptRunner(fixture.session);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 move (dist | distance distanceFront",
                "1 move (1 distanceF | distanceFront",
                "1 move (2 * ra | random",
                "1 move ($| $far $n",
                "1 move -$F | $far",
                "1 move ($n + a | abs age aibo",
                "let m = ab | abs",
                "let m = 1 dist | distanceFront",
                "let f | far",
                "ask f | far",
                "ask m = 3mm f | for from",
                "ask m = left o | or",
                "print $n | $n",
                "print (mi | min",
                "on 1 bu | bumped",
                "while 1 x < $ | $far $n",
                "while (di | distance",
                "sq | square",
                "distance | ''",
                "1 move (distance 1 a | aibo",
                "print \"costs $ | ''",
                "1 move 3 # $ | ''"
            })
    void namesAndFunctionsFitExpressions(String text, String words) {
        fixture.prompt.parseText("let n = 3");
        fixture.prompt.parseText("let far = 300mm");
        fixture.prompt.parseText("to square side\n1 move $side\nend");
        assertThat(String.join(" ", fixture.prompt.complete(text, text.length()).words()))
                .isEqualTo(words);
    }

    @Test
    void aNameOfThePromptHasItsValueAndAProcedureItsArguments() throws InterruptedException {
        fixture.prompt.parseText("let far = 300mm + 20");
        fixture.prompt.parseText("to square side\n1 move $side\nend");
        fixture.prompt.awaitAll();
        assertThat(fixture.prompt.complete("1 move $", 8).entries())
                .containsExactly(new Completion("$far", "320 mm", ""));
        assertThat(fixture.prompt.complete("squ", 3).entries())
                .containsExactly(new Completion("square", "SIDE", "a procedure"));
        assertThat(fixture.prompt.complete("square ", 7).entries())
                .containsExactly(new Completion("", "square SIDE", "a value for side"));
    }

    @Test
    void anOpenBlockHasItsNamesToo() {
        fixture.prompt.parseText("to square side");
        fixture.prompt.parseText("let half = 50mm");
        assertThat(fixture.prompt.complete("1 move $", 8).words()).containsExactly("$half", "$side");
    }

    private static final String SCRIPT = """
            argument speed = 60mm/s "how fast"
            let n = 1 distanceFront
            to corner side
              let half = $side / 2
              1 move $
            end
            repeat 2
              ask turns = 3
              let inner = yes
            end
            corner $
            """;

    @ParameterizedTest
    @CsvSource({"2, $speed", "5, $half $n $side $speed", "9, $n $speed $turns", "11, $n $speed"})
    void aLineOfAScriptMayUseTheNamesInFrontOfIt(int line, String names) {
        assertThat(runner().completeVariable(runner().names(SCRIPT, line), "1 move $", 8))
                .get()
                .satisfies(found -> assertThat(String.join(" ", found.words())).isEqualTo(names));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "11 | 1 move $n_ | $n a number of mm",
                "11 | 1 move -$sp_eed | $speed mm/s, default 60 mm/s: how fast",
                "5 | 1 move $si_de | $side: a value",
                "9 | 1 move $turns_ | $turns a number without a unit",
                "11 | cor_ner 5 | corner SIDE: a procedure",
                "11 | 1 move (ab_s 3) | abs VALUE: the value without its sign",
                "11 | 1 move (1 dist_anceFront / 2) | distanceFront mm: what is ahead",
                "11 | _let n = 4 | let NAME = VALUE: gives a value a name, as in let n = $n + 1; in a line $NAME or an expression in brackets stands for a value: 1 move ($n * 100)",
                "11 | _on 1 x > 3 | on CONDITION ... end: each time it becomes true, while the script runs"
            })
    void theWordsOfValuesAreExplained(int number, String text, String words) {
        String line = text.replace("_", "");
        assertThat(runner().explain(line, text.indexOf('_'), runner().names(SCRIPT, number))
                        .map(Completion::inWords)
                        .orElse(""))
                .isEqualTo(words);
    }

    @Test
    void looksAtTheWordBeforeTheCaret() {
        assertThat(fixture.prompt.complete("1 mo 500", 4).words()).containsExactly("move");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 move~ | mm, cm, m | a distance",
                "1 move -5 | mm, cm, m | a distance",
                "1 drive 10 | mm/s, m/s | a speed",
                "1 drive 10~ | deg/s, rad/s | a turn rate",
                "1 drive 10 10 for~ | s, ms | a time",
                "1 set headPan~ | -91 … 91 deg | headPan: where the head looks, left positive",
                "1 set headPan 3.5 | -91 … 91 deg | headPan: where the head looks, left positive",
                "1 set headPan 30~ | 0 … 10 s | time: how long it takes",
                "1 wag~ | 1 … 10 number | times: how often",
                "1 log x every~ | s, ms | a time"
            })
    void aHintStatesWhatIsExpectedWhereNoWordIs(String text, String values, String explanation) {
        String typed = text.replace('~', ' ');
        assertThat(fixture.prompt.complete(typed, typed.length()).entries())
                .containsExactly(new Completion("", values, explanation));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 move $ | $far $fast",
                "1 move -$FA | $far $fast",
                "1 drive $fas | $fast",
                "1 move $x | ''",
                "1 mo | -"
            })
    void theNamesOfAScriptsArgumentsFollowADollarSign(String line, String names) {
        String script =
                "argument far = 300mm \"how far\"\nargument fast = 60mm/s from 0 to 200\n1 mvoe\n" + line + "\n";
        assertThat(runner().completeVariable(runner().names(script, 4), line, line.length())
                        .map(found -> String.join(" ", found.words()))
                        .orElse("-"))
                .isEqualTo(names);
    }

    @Test
    void anArgumentShowsItsRangeDefaultAndExplanation() {
        String script = "argument fast = 60mm/s from 0 to 200 \"how fast\"\n1 drive $\n";
        assertThat(runner().completeVariable(runner().names(script, 2), "1 drive $", 9))
                .contains(new Completions(
                        8, List.of(new Completion("$fast", "0 … 200 mm/s, default 60 mm/s", "how fast"))));
        assertThat(fixture.prompt.complete("1 act AiboSquare s", 18).entries())
                .singleElement()
                .satisfies(entry -> assertThat(entry.values()).endsWith(" mm, default 500 mm"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 mov | move | DISTANCE [until CONDITION] | straight ahead; negative is backward",
                "1 set headP | headPan | -91 … 91 deg | where the head looks, left positive",
                "1 get bum | bumped | yes/no | whether it touches something",
                "1 wa | wag | TIMES | wags the tail",
                "1 | 1 | | Aibo",
            })
    void aWordHasWhatItTakesAndItsExplanation(String text, String word, String values, String explanation) {
        assertThat(fixture.prompt.complete(text, text.length()).entries())
                .contains(new Completion(word, values == null ? "" : values, explanation));
    }

    @ParameterizedTest
    @ValueSource(strings = {"9 get x y", "1 mvoe 5", "1 move x y", "# mo", "1 get x # vo", "bots "})
    void nothingIsOfferedWhereNothingFits(String text) {
        assertThat(fixture.prompt.complete(text, text.length()).entries()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 mo | 2",
                "1 get x,volt | 8",
                "1.tu | 2",
                "1 set headPan -3.5 | 14",
                "add sim:ai | 4",
                "1 act \"to the | 6",
                "1 get | 2"
            })
    void theBegunWordIsReplaced(String text, int start) {
        assertThat(fixture.prompt.complete(text, text.length()).start()).isEqualTo(start);
    }

    @Test
    void aNameThatBeginsWithAQuoteIsCompleted() {
        assertThat(fixture.prompt.complete("1 act \"A", 8).entries()).isEmpty();
        assertThat(fixture.prompt.complete("1 act AiboSq", 12).entries())
                .singleElement()
                .satisfies(entry -> assertThat(entry.explanation()).isNotBlank());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 tu_rn 90 | turn ANGLE [until CONDITION]: on the spot, left positive",
                "_turn | ''",
                "1 turn _ | an angle (deg, rad)",
                "1 turn 90_deg | an angle (deg, rad)",
                "_1 turn 90 | 1: Aibo",
                "1 get distanceFront_ | distanceFront mm: what is ahead",
                "1 set headPan 3_0 | headPan: where the head looks, left positive (-91 … 91 deg)",
                "_repeat 3 | repeat [N] ... end: N times, or for ever",
                "1 _act race | act NAME [ARGUMENT=VALUE...] [with ROBOTS]: runs an act, a script or an .act file; \"1 act off\" ends it",
                "1 act ra_ce | ''",
                "1 move 3 # move_ it | ''"
            })
    void explainsTheWordThatThePlaceTouches(String text, String words) {
        String line = text.replace("_", "");
        assertThat(runner().explain(line, text.indexOf('_'), VisibleNames.NONE)
                        .map(Completion::inWords)
                        .orElse(""))
                .isEqualTo(words);
    }
}

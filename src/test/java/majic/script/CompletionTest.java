package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.script.help.Completion;
import majic.script.help.Completions;
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
        assertThat(new ScriptRunner(fixture.session)
                        .completeVariable(script, line, line.length())
                        .map(found -> String.join(" ", found.words()))
                        .orElse("-"))
                .isEqualTo(names);
    }

    @Test
    void anArgumentShowsItsRangeDefaultAndExplanation() {
        String script = "argument fast = 60mm/s from 0 to 200 \"how fast\"\n1 drive $\n";
        assertThat(new ScriptRunner(fixture.session).completeVariable(script, "1 drive $", 9))
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
        assertThat(new ScriptRunner(fixture.session)
                        .explain(line, text.indexOf('_'))
                        .map(Completion::inWords)
                        .orElse(""))
                .isEqualTo(words);
    }
}

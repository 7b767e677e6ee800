package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the Tab key offers. */
class CompletionTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "re | release remove repeat",
                "a | acts add aibo all",
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
                "1 move 500 until distanceFront < n | near no",
                "1 drive 10 10 f | for",
                "if 1 bumped == yes o | or",
                "save s | session",
                "add s | sim:aibo sim:pioneer",
                "1 log o | off",
                "help rep | repeat"
            })
    void fitsThePlace(String text, String words) {
        assertThat(fixture.prompt.complete(text, text.length())).containsExactly(words.split(" "));
    }

    @Test
    void looksAtTheWordBeforeTheCaret() {
        assertThat(fixture.prompt.complete("1 mo 500", 4)).containsExactly("move");
    }

    @Test
    void offersNothingWhereAnyTextIsAllowed() {
        assertThat(fixture.prompt.complete("1 move ", 7)).isEmpty();
        assertThat(fixture.prompt.complete("9 get x", 7)).isEmpty();
    }
}

package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BotTypeTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "nobody answers | nobody answers. Imagine it harder.",
                "nobody answers. | nobody answers. Imagine it harder.",
                "no port; is it plugged in? | no port; is it plugged in?"
            })
    void adviceStandsBehindAWholeSentenceButNotBehindAQuestion(String problem, String both) {
        assertThat(new FakeType().adviceAfter(problem)).isEqualTo(both);
    }
}

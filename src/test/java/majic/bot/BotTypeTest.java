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
                "is it switched on? | is it switched on? Imagine it harder."
            })
    void adviceStandsBehindAWholeSentence(String problem, String both) {
        assertThat(new FakeType().adviceAfter(problem)).isEqualTo(both);
    }
}

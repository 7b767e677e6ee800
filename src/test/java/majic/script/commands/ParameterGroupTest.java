package majic.script.commands;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import org.junit.jupiter.api.Test;

class ParameterGroupTest {
    @Test
    void putsParametersTogetherThatDifferInTheirNumberOnly() {
        List<Parameter> table = List.of(
                range("sonar"),
                range("sonar0"),
                range("sonar1"),
                range("sonar2"),
                Parameter.number("sonar3", Unit.DEG, "another thing"),
                range("light1"),
                range("light3"));

        assertThat(ParameterGroup.of(table))
                .extracting(ParameterGroup::name)
                .containsExactly("sonar", "sonar0 … sonar2", "sonar3", "light1", "light3");
    }

    private static Parameter range(String name) {
        return Parameter.number(name, Unit.MM, "a range");
    }
}

package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ParameterTest {
    private static final Parameter CYCLE =
            Parameter.number("cycle", Unit.MS, "how often").within(10, 1000).inWholes();

    @Test
    void aWholeNumberTakesNoFractions() {
        assertThatThrownBy(() -> CYCLE.fit(Value.of(20.5, Unit.NONE)))
                .isInstanceOf(ParameterException.class)
                .hasMessage("cycle 20.5: not a whole number");
    }

    @Test
    void fractionsOfSecondsMayBeWholeMilliseconds() {
        assertThat(CYCLE.fit(Value.of(0.057, Unit.S)).number()).isEqualTo(57);
    }
}

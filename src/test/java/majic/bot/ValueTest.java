package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ValueTest {
    @ParameterizedTest
    @CsvSource({
        "4.658, DEG, 4.7 deg",
        "0.04, DEG, 0 deg",
        "-0.04, MM, 0 mm",
        "497.6, MM, 498 mm",
        "12.34, MM_PER_S, 12.3 mm/s",
        "1.304, V, 1.3 V",
        "4.885, V, 4.89 V",
        "12.85, V, 12.9 V",
        "2.134, S, 2.13 s",
        "99.6, MS, 100 ms",
        "0.0313, NONE, 0.031",
        "500, MM_PER_S2, 500 mm/s²",
        "36.6, CELSIUS, 36.6 °C"
    })
    void isShownNoFinerThanItsUnitMakesSenseOf(double amount, Unit unit, String shown) {
        assertThat(Value.of(amount, unit)).hasToString(shown);
    }

    @Test
    void keepsTheExactNumberBehindWhatIsShown() {
        assertThat(Value.of(4.658, Unit.DEG).number()).isEqualTo(4.658);
    }

    @Test
    void aNegativeZeroIsZero() {
        assertThat(Value.of(-0.0, Unit.MM)).isEqualTo(Value.of(0, Unit.MM));
        assertThat(String.valueOf(Value.of(-0.0, Unit.MM).number())).isEqualTo("0.0");
    }
}

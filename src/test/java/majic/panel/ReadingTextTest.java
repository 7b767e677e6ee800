package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReadingTextTest {
    @ParameterizedTest
    @CsvSource({
        "headPan, head pan",
        "distanceFront, distance front",
        "backSensorM, back sensor M",
        "x, x",
        "round trip, round trip"
    })
    void aLabelIsTheNameInPlainWords(String parameter, String label) {
        assertThat(ReadingText.label(parameter)).isEqualTo(label);
    }

    @Test
    void anglesHaveTheDegreeSign() {
        assertThat(ReadingText.of(Value.about(40, Unit.DEG))).isEqualTo("40°");
        assertThat(ReadingText.of(Value.of(-30, Unit.DEG_PER_S))).isEqualTo("-30 °/s");
    }

    @Test
    void otherUnitsStayAsInCommands() {
        assertThat(ReadingText.of(Value.of(512, Unit.MM))).isEqualTo("512 mm");
    }

    @ParameterizedTest
    @CsvSource({"0.9, 0 s", "59, 59 s", "60, 1 min", "3599, 59 min", "7300, 2 h"})
    void anAgeHasOneUnit(double seconds, String age) {
        assertThat(ReadingText.age(seconds)).isEqualTo(age);
    }
}

package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReadingTextTest {
    private final Locale before = Locale.getDefault();

    @AfterEach
    void restoreLanguage() {
        Locale.setDefault(before);
    }

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
        assertThat(ReadingText.of(Value.of(-30, Unit.DEG_PER_S))).isEqualTo("−30 °/s");
    }

    @Test
    void otherUnitsStayAsInCommands() {
        assertThat(ReadingText.of(Value.of(512, Unit.MM))).isEqualTo("512 mm");
    }

    @ParameterizedTest
    @CsvSource({"en, no, on, clear", "de, nein, an, frei"})
    void wordsOfValuesAreInTheUsersLanguage(String language, String no, String on, String clear) {
        Locale.setDefault(Locale.forLanguageTag(language));

        assertThat(ReadingText.of(Value.yesNo(false))).isEqualTo(no);
        assertThat(ReadingText.of(Value.onOff(true))).isEqualTo(on);
        assertThat(ReadingText.of(Value.CLEAR)).isEqualTo(clear);
        assertThat(ReadingText.of(Value.text("stand"))).isEqualTo("stand");
    }

    @ParameterizedTest
    @CsvSource({"0.9, 0 s", "59, 59 s", "60, 1 min", "3599, 59 min", "7300, 2 h"})
    void anAgeHasOneUnit(double seconds, String age) {
        assertThat(ReadingText.age(seconds)).isEqualTo(age);
    }
}

package majic.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ValueTextTest {
    private static final Parameter X = Parameter.number("x", Unit.MM, "ahead");
    private static final Parameter SONAR = Parameter.list("sonar", Unit.MM, "ranges");

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, 0",
        "12, 12",
        "-7, -7",
        "1234.56, 1234.6",
        "12.345, 12.35",
        "1.23456, 1.235",
        "0.00001, 0.00001",
        "0.000001, 0",
        "-0.5, -0.5",
        "99.996, 100"
    })
    void numbersHaveNoMoreDigitsThanSensors(double number, String text) {
        assertThat(ValueText.of(number)).isEqualTo(text);
    }

    @Test
    void aPlaceOnTheEarthKeepsAllItsDigits() {
        for (String text : List.of("-35.3632377", "149.1652203", "0.0000001", "12.5", "-7", "0")) {
            Value place = Value.of(Double.parseDouble(text), Unit.LAT_LON);
            assertThat(ValueText.of(place)).isEqualTo(text);
            Track track = new Track();
            track.add(0, text);
            assertThat(track.text(0)).isEqualTo(text);
            assertThat(track.numberAt(0)).isEqualTo(place.number());
        }
    }

    @Test
    void theTextOfANumberIsReadExactly() {
        Random random = new Random(5);
        for (int round = 0; round < 20_000; round++) {
            double number = (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(9) - 4);
            String text = ValueText.of(number);
            assertThat(ValueText.exact(text)).isEqualTo(Double.parseDouble(text));
            assertThat(ValueText.of(ValueText.exact(text))).isEqualTo(text);
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "-", ".", "1.", ".5", "-0", "01", "1.50", "1e3", "1d", "yes", "12.345", "1 2", "+1", "0x1"})
    void otherTextsAreKeptAsTheyAre(String text) {
        assertThat(ValueText.exact(text)).isNaN();
    }

    @Test
    void valuesAreReadAsTheyWere() {
        List<Value> values = List.of(Value.of(12.5, Unit.MM), Value.CLEAR, Value.unknown("no reading yet"));
        for (Value value : values) {
            assertThat(ValueText.value(ValueText.of(value), X, false)).isEqualTo(value);
        }
        Value many = Value.many(List.of(Value.of(1, Unit.MM), Value.CLEAR, Value.of(-2.5, Unit.MM)));
        assertThat(ValueText.value(ValueText.of(many), SONAR, false)).isEqualTo(many);
    }
}

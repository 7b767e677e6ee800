package majic.gui.plot;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ClockTextTest {
    @ParameterizedTest
    @CsvSource({
        "0, 60, 0:00",
        "125.4, 60, 2:05",
        "125.44, 5, 2:05.4",
        "59.96, 5, 1:00.0",
        "3725, 600, 1:02:05",
        "-5, 60, −0:05",
        "-0.2, 60, 0:00"
    })
    void timesAreMinutesAndSeconds(double seconds, double shown, String text) {
        assertThat(ClockText.of(seconds, shown)).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource({"0.07, 0.1", "4, 5", "11, 15", "3601, 7200", "8000, 14400"})
    void timesOnTheAxisAreRound(double leastS, double stepS) {
        assertThat(TimeAxisDrawing.step(leastS)).isEqualTo(stepS);
    }
}

package majicsim.aibo.urbi.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecimalsTest {
    @ParameterizedTest
    @CsvSource({
        "0, 0.000000",
        "-0.0, -0.000000",
        "-0.0000001, -0.000000",
        "0.9999996, 1.000000",
        "-29.5, -29.500000",
        "123456789, 123456789.000000",
        "999999999999999, 999999999999999.000000"
    })
    void aNumberHasSixDecimals(double number, String printed) {
        assertThat(Decimals.six(number)).isEqualTo(printed);
    }

    @Test
    void theShortWayPrintsWhatTheLongOneDoes() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; i++) {
            double number = random.nextGaussian() * Math.pow(10, random.nextInt(12) - 4);

            assertThat(Decimals.six(number)).isEqualTo(String.format(Locale.ROOT, "%.6f", number));
        }
    }
}

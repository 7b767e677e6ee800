package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class FrameRateTest {
    private static final long TENTH = 100_000_000;

    private final FrameRate rate = new FrameRate();

    @Test
    void onePictureIsNoRate() {
        assertThat(rate.arrived(TENTH)).isZero();
    }

    @Test
    void picturesATenthOfASecondApartAreTenASecond() {
        assertThat(after(0, 30, TENTH)).isCloseTo(10, within(0.01));
    }

    @Test
    void theLastTwoSecondsCount() {
        after(0, 30, TENTH);

        assertThat(after(100 * TENTH, 6, 5 * TENTH)).isCloseTo(2, within(0.01));
    }

    private double after(long nanos, int pictures, long apart) {
        double last = 0;
        for (int picture = 0; picture < pictures; picture++) {
            last = rate.arrived(nanos + picture * apart);
        }
        return last;
    }
}

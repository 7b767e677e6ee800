package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class UncertaintyTest {
    @Test
    void itGrowsMostAcrossTheWay() {
        Uncertainty is = Uncertainty.of(10, 1);
        for (int step = 1; step <= 50; step++) {
            is = is.after(0, new Pose(100, 0, 0));
        }

        assertThat(Math.sqrt(is.xx())).isCloseTo(100 * Math.sqrt(5), within(5.0));
        assertThat(is.yy()).isGreaterThan(is.xx());
        assertThat(is.sigmaDeg()).isCloseTo(Math.sqrt(1 + 9 * 5), within(0.1));
        assertThat(is.sigmaMm()).isCloseTo(Math.sqrt(is.yy()), within(1.0));
    }

    @Test
    void aTurnOfTheWholeWorldTurnsTheEllipse() {
        Uncertainty ahead = Uncertainty.of(10, 1).after(0, new Pose(5000, 0, 0));
        Uncertainty left = Uncertainty.of(10, 1).after(90, new Pose(5000, 0, 0));

        assertThat(left.xx()).isCloseTo(ahead.yy(), within(1e-6));
        assertThat(left.yy()).isCloseTo(ahead.xx(), within(1e-6));
        assertThat(left.sigmaMm()).isCloseTo(ahead.sigmaMm(), within(1e-6));
    }

    @Test
    void aRobotThatStandsStaysAsCertainAsItWas() {
        assertThat(Uncertainty.of(10, 1).after(30, Pose.START)).isEqualTo(Uncertainty.of(10, 1));
    }

    @Test
    void whatIsUnknownStaysUnknown() {
        Uncertainty is = Uncertainty.UNKNOWN.after(0, new Pose(1000, 0, 0));

        assertThat(is.isKnown()).isFalse();
        assertThat(is.sigmaMm()).isInfinite();
        assertThat(is.sigmaDeg()).isInfinite();
    }
}

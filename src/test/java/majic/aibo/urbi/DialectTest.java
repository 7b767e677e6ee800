package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class DialectTest {
    @Test
    void numbersNeverHaveAnExponent() {
        assertThat(Dialect.number(0.0001)).isEqualTo("0.0001");
        assertThat(Dialect.number(1_234_567_890_123.0)).isEqualTo("1234567890123");
        assertThat(Dialect.number(-0.5)).isEqualTo("-0.5");
        assertThat(Dialect.number(1e-9)).isEqualTo("0");
        assertThat(Dialect.number(100)).isEqualTo("100");
    }

    @Test
    void theBannerTellsTheGeneration() {
        assertThat(Dialect.of("URBI Kernel version 1.5 rev. 1", Dialect.V1_0)).isEqualTo(Dialect.V1_5);
        assertThat(Dialect.of("URBI Kernel version 1.0 rev. 153", Dialect.V1_5)).isEqualTo(Dialect.V1_0);
        assertThat(Dialect.of("see LICENSE for details.", Dialect.V1_5)).isEqualTo(Dialect.V1_5);
    }

    @Test
    void eachGenerationNamesAnswersInItsOwnWay() {
        assertThat(Dialect.V1_0.labelled("t", "headPan.val")).isEqualTo("t: headPan.val");
        assertThat(Dialect.V1_5.labelled("t", "headPan.val")).isEqualTo("t << headPan.val");
    }
}

package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class UrbiVersionTest {
    @Test
    void numbersNeverHaveAnExponent() {
        assertThat(UrbiVersion.number(0.0001)).isEqualTo("0.0001");
        assertThat(UrbiVersion.number(1_234_567_890_123.0)).isEqualTo("1234567890123");
        assertThat(UrbiVersion.number(-0.5)).isEqualTo("-0.5");
        assertThat(UrbiVersion.number(1e-9)).isEqualTo("0");
        assertThat(UrbiVersion.number(100)).isEqualTo("100");
    }

    @Test
    void theBannerTellsTheGeneration() {
        assertThat(UrbiVersion.of("URBI Kernel version 1.5 rev. 1", UrbiVersion.V1_0))
                .isEqualTo(UrbiVersion.V1_5);
        assertThat(UrbiVersion.of("URBI Kernel version 1.0 rev. 153", UrbiVersion.V1_5))
                .isEqualTo(UrbiVersion.V1_0);
        assertThat(UrbiVersion.of("see LICENSE for details.", UrbiVersion.V1_5)).isEqualTo(UrbiVersion.V1_5);
    }

    @Test
    void eachGenerationNamesAnswersInItsOwnWay() {
        assertThat(UrbiVersion.V1_0.labelled("t", "headPan.val")).isEqualTo("t: headPan.val");
        assertThat(UrbiVersion.V1_5.labelled("t", "headPan.val")).isEqualTo("t << headPan.val");
    }
}

package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NoiseTest {
    @Test
    void theExactSourceReturnsMeans() {
        Noise noise = Noise.exact().fork("anyone");
        assertThat(noise.isExact()).isTrue();
        assertThat(noise.scale(0.5)).isEqualTo(1);
        assertThat(noise.gaussian(3)).isZero();
        assertThat(noise.uniform(2, 4)).isEqualTo(3);
        assertThat(noise.chance(0.99)).isFalse();
    }

    @Test
    void theSameSeedGivesTheSameNumbersAgain() {
        assertThat(Noise.seeded(7).gaussian(1)).isEqualTo(Noise.seeded(7).gaussian(1));
        assertThat(Noise.seeded(7).gaussian(1)).isNotEqualTo(Noise.seeded(8).gaussian(1));
    }

    @Test
    void aForkDoesNotDependOnWhatOthersDrew() {
        Noise parent = Noise.seeded(7);
        double before = parent.fork("sonar").gaussian(1);
        parent.uniform(0, 1);
        assertThat(parent.fork("sonar").gaussian(1)).isEqualTo(before);
        assertThat(parent.fork("odometry").gaussian(1)).isNotEqualTo(before);
    }
}

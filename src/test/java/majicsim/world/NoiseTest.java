package majicsim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
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

    /** So that recorded sessions of a lab can be repeated by a later version. */
    @Test
    void aSeedAlwaysGivesTheSameNumbers() {
        Noise noise = Noise.seeded(5);

        assertThat(List.of(noise.uniform(0, 1), noise.gaussian(1), noise.gaussian(1), noise.uniform(0, 1)))
                .containsExactly(0.7003519617727735, -0.9965173895881172, 0.8996357728259392, 0.22418481914992106);
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

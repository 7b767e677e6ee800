package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PoseFrameTest {
    @Test
    void aheadOfARobotThatLooksUpIsUp() {
        Pose place = new Pose(1000, 500, 90).plus(new Pose(200, 0, 10));
        assertThat(place.distanceMm(new Pose(1000, 700, 0))).isLessThan(1e-6);
        assertThat(place.headingDeg()).isEqualTo(100);
    }

    @Test
    void aPlaceBehindIsANegativeDistanceAheadAndOneAsideIsNone() {
        Pose looksUp = new Pose(1000, 500, 90);
        assertThat(looksUp.aheadMm(new Pose(1000, 200, 0))).isCloseTo(-300, within(1e-9));
        assertThat(looksUp.aheadMm(new Pose(700, 500, 0))).isCloseTo(0, within(1e-9));
        assertThat(looksUp.aheadMm(new Pose(5000, 520, 0))).isCloseTo(20, within(1e-9));
    }

    @Test
    void theOriginTakesAPoseToItsPlace() {
        Pose place = new Pose(700, -200, 30);
        Pose relative = new Pose(123, 45, -60);
        Pose back = place.originOf(relative).plus(relative);
        assertThat(back.distanceMm(place)).isLessThan(1e-6);
        assertThat(back.headingDeg()).isEqualTo(30);
    }
}

package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class PoseFramesTest {
    @Test
    void aheadOfARobotThatLooksUpIsUp() {
        Pose place = PoseFrames.at(new Pose(1000, 500, 90), new Pose(200, 0, 10));
        assertThat(place.distanceMm(new Pose(1000, 700, 0))).isLessThan(1e-6);
        assertThat(place.headingDeg()).isEqualTo(100);
    }

    @Test
    void theOriginTakesAPoseToItsPlace() {
        Pose place = new Pose(700, -200, 30);
        Pose relative = new Pose(123, 45, -60);
        Pose back = PoseFrames.at(PoseFrames.originOf(place, relative), relative);
        assertThat(back.distanceMm(place)).isLessThan(1e-6);
        assertThat(back.headingDeg()).isEqualTo(30);
    }
}

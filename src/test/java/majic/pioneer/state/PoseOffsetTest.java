package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class PoseOffsetTest {
    private final PoseOffset placement = new PoseOffset();

    @Test
    void leavesPosesUnchangedUntilOneIsSet() {
        assertThat(placement.of(new Pose(10, -20, 30))).isEqualTo(new Pose(10, -20, 30));
    }

    @Test
    void turnsWhatComesAfterwardsWithTheHeadingThatWasSet() {
        placement.put(new Pose(1000, 500, 170), new Pose(100, 200, 90));

        Pose ahead = placement.of(new Pose(1000, 500, 170).after(300, 0));

        assertThat(ahead.xMm()).isCloseTo(100, within(1e-6));
        assertThat(ahead.yMm()).isCloseTo(500, within(1e-6));
        assertThat(ahead.headingDeg()).isCloseTo(90, within(1e-6));
    }

    @Test
    void canBeSetAgainAndAgain() {
        placement.put(new Pose(5, 5, 5), new Pose(1, 2, 3));
        placement.put(new Pose(7, 8, 9), new Pose(-1, -2, -180));

        assertThat(placement.of(new Pose(7, 8, 9))).isEqualTo(new Pose(-1, -2, 180));
    }
}

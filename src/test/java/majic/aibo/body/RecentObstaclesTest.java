package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class RecentObstaclesTest {
    private final RecentObstacles surroundings = new RecentObstacles();

    @Test
    void aWallAheadIsMeasuredFromTheHull() {
        surroundings.look(Pose.START, 0, Optional.of(400.0), 1000);

        assertThat(surroundings.frontMm(Pose.START)).contains(400 + 120 - 150.0);
    }

    @Test
    void whatIsMetWalksNearerWithTheDog() {
        surroundings.look(Pose.START, 0, Optional.of(400.0), 1000);

        assertThat(surroundings.frontMm(new Pose(100, 0, 0))).contains(270.0);
    }

    @Test
    void whatLiesBesideTheCorridorIsNotInTheWay() {
        surroundings.look(Pose.START, 45, Optional.of(400.0), 1000);

        assertThat(surroundings.frontMm(Pose.START)).isEmpty();
        assertThat(surroundings.frontMm(new Pose(0, 150, 0))).isPresent();
    }

    @Test
    void theNearestOfASweepCounts() {
        surroundings.look(Pose.START, 30, Optional.of(300.0), 1000);
        surroundings.look(Pose.START, 0, Optional.empty(), 1500);

        assertThat(surroundings.frontMm(Pose.START).orElseThrow()).isBetween(220.0, 240.0);
    }

    @Test
    void whatWasNotMetAgainInASweepIsForgotten() {
        surroundings.look(Pose.START, 0, Optional.of(300.0), 1000);
        surroundings.look(Pose.START, 0, Optional.empty(), 4000);

        assertThat(surroundings.frontMm(Pose.START)).isEmpty();
    }
}

package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class RecentObstaclesTest {
    private final RecentObstacles obstacles = new RecentObstacles();

    @Test
    void aWallAheadIsMeasuredFromTheHull() {
        obstacles.add(Pose.START, 0, Optional.of(400.0), 1000);

        assertThat(obstacles.frontMm(Pose.START)).contains(400 + 120 - 150.0);
    }

    @Test
    void anObstacleComesNearerAsTheDogWalks() {
        obstacles.add(Pose.START, 0, Optional.of(400.0), 1000);

        assertThat(obstacles.frontMm(new Pose(100, 0, 0))).contains(270.0);
    }

    @Test
    void anObstacleBesideTheCorridorIsIgnored() {
        obstacles.add(Pose.START, 45, Optional.of(400.0), 1000);

        assertThat(obstacles.frontMm(Pose.START)).isEmpty();
        assertThat(obstacles.frontMm(new Pose(0, 150, 0))).isPresent();
    }

    @Test
    void theNearestOfASweepCounts() {
        obstacles.add(Pose.START, 30, Optional.of(300.0), 1000);
        obstacles.add(Pose.START, 0, Optional.empty(), 1500);

        assertThat(obstacles.frontMm(Pose.START).orElseThrow()).isBetween(220.0, 240.0);
    }

    @Test
    void anObstacleThatASweepDoesNotFindAgainIsDiscarded() {
        obstacles.add(Pose.START, 0, Optional.of(300.0), 1000);
        obstacles.add(Pose.START, 0, Optional.empty(), 4000);

        assertThat(obstacles.frontMm(Pose.START)).isEmpty();
    }
}

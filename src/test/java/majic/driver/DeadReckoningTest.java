package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Pose;
import org.junit.jupiter.api.Test;

/** The pose that follows from commanded motions. */
class DeadReckoningTest {
    private final DeadReckoning reckoning = new DeadReckoning();

    private static DeadReckoning.Segment straight(long beginning, long end) {
        return (start, time) -> start.after(Math.min(time, end) - beginning, 0);
    }

    @Test
    void aRobotWithoutCommandsIsAtItsStart() {
        assertThat(reckoning.at(1000)).isEqualTo(Pose.START);
    }

    @Test
    void eachMotionBeginsWhereTheOneBeforeWasInterrupted() {
        reckoning.begin(straight(0, 100), 0);
        reckoning.begin((start, time) -> start.after(0, 90), 40);
        reckoning.begin(straight(50, 100), 50);

        assertThat(reckoning.at(60)).isEqualTo(new Pose(40, 10, 90));
    }

    @Test
    void aMotionThatHasEndedByItselfCountsInFull() {
        reckoning.begin(straight(0, 100), 0);
        reckoning.begin(DeadReckoning.Segment.STATIONARY, Long.MAX_VALUE);

        assertThat(reckoning.at(30)).isEqualTo(new Pose(100, 0, 0));
    }

    @Test
    void aResetReturnsToTheStart() {
        reckoning.begin(straight(0, 100), 0);
        reckoning.reset();

        assertThat(reckoning.at(50)).isEqualTo(Pose.START);
    }
}

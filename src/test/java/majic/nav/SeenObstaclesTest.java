package majic.nav;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What a robot without range sensors sees, which measures the distance ahead of its hull of 200 mm. */
class SeenObstaclesTest {
    @AutoClose
    private final TestClock clock = new TestClock();

    private FakeBot robot;
    private SeenObstacles seen;

    @BeforeEach
    void addARobot() {
        robot = FakeBot.on(clock.time());
        robot.connect();
        seen = new SeenObstacles(robot, (xMm, yMm) -> false);
    }

    @AfterEach
    void closeTheRobot() {
        robot.close();
    }

    private void lookAfterTwoSeconds() throws InterruptedException {
        clock.time().sleep(2);
        seen.lookAhead(new Pose(1000, 0, 90));
    }

    @Test
    void anObstacleIsAheadOfTheHull() throws InterruptedException {
        robot.tell("distanceFront", Value.of(500, Unit.MM));
        lookAfterTwoSeconds();

        assertThat(seen.points()).singleElement().satisfies(point -> {
            assertThat(point.xMm()).isBetween(999.0, 1001.0);
            assertThat(point.yMm()).isBetween(699.0, 701.0);
        });
    }

    @Test
    void aClearWayIsAReading() throws InterruptedException {
        robot.tell("distanceFront", Value.CLEAR);
        lookAfterTwoSeconds();

        assertThat(seen.ageS()).isLessThan(1);
        assertThat(seen.points()).isEmpty();
    }

    @Test
    void anUnknownDistanceIsNoReading() throws InterruptedException {
        robot.tell("distanceFront", Value.unknown("the sensor does not answer"));
        lookAfterTwoSeconds();

        assertThat(seen.ageS()).isGreaterThanOrEqualTo(2);
        assertThat(SeenObstacles.looksAhead(robot)).isTrue();
    }
}

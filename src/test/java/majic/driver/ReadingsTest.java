package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.BotState;
import majic.bot.Pose;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;

class ReadingsTest {
    private final Readings readings = new Readings(TimeSource.system().signal());

    @Test
    void leavesPosesUnchangedUntilTheRobotIsPlaced() {
        assertThat(reported(new Pose(10, -20, 30))).isEqualTo(new Pose(10, -20, 30));
        assertThat(readings.placedAt()).isEmpty();
    }

    @Test
    void turnsWhatComesAfterwardsWithTheHeadingThatWasSet() {
        reported(new Pose(1000, 500, 170));
        readings.place(new Pose(100, 200, 90));

        assertSame(reported(new Pose(1000, 500, 170).after(300, 0)), new Pose(100, 500, 90));
    }

    @Test
    void aRobotCanBePlacedAgainAndAgain() {
        reported(new Pose(5, 5, 5));
        readings.place(new Pose(1, 2, 3));
        reported(new Pose(7, 8, 9));

        readings.place(new Pose(-1, -2, -180));
        assertSame(readings.state().pose(), new Pose(-1, -2, 180));
        assertThat(readings.placedAt()).contains(new Pose(-1, -2, 180));
    }

    @Test
    void aPlacedRobotStaysWhereItWasWhenItsOdometryStartsAgain() {
        reported(Pose.START);
        readings.place(new Pose(1000, 2000, 90));
        reported(new Pose(300, 0, 0));
        readings.reconnecting();

        assertSame(reported(Pose.START), new Pose(1000, 2300, 90));
        assertSame(reported(new Pose(100, 0, 0)), new Pose(1000, 2400, 90));
    }

    @Test
    void aRobotThatWasNotPlacedStartsAgainWithItsOdometry() {
        reported(new Pose(300, 0, 0));
        readings.reconnecting();

        assertThat(reported(Pose.START)).isEqualTo(Pose.START);
    }

    private Pose reported(Pose odometry) {
        readings.report(new BotState(odometry, 0, 0, false, 1));
        return readings.state().pose();
    }

    private static void assertSame(Pose pose, Pose expected) {
        assertThat(pose.xMm()).isCloseTo(expected.xMm(), within(1e-6));
        assertThat(pose.yMm()).isCloseTo(expected.yMm(), within(1e-6));
        assertThat(Pose.normalised(pose.headingDeg() - expected.headingDeg())).isCloseTo(0, within(1e-6));
    }
}

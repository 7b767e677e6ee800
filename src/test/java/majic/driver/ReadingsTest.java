package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.BotState;
import majic.bot.Pose;
import majic.bot.Uncertainty;
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
        readings.place(new Pose(100, 200, 90), Uncertainty.BY_HAND);

        assertSame(reported(new Pose(1000, 500, 170).after(300, 0)), new Pose(100, 500, 90));
    }

    @Test
    void aRobotCanBePlacedAgainAndAgain() {
        reported(new Pose(5, 5, 5));
        readings.place(new Pose(1, 2, 3), Uncertainty.BY_HAND);
        reported(new Pose(7, 8, 9));

        readings.place(new Pose(-1, -2, -180), Uncertainty.BY_HAND);
        assertSame(readings.state().pose(), new Pose(-1, -2, 180));
        assertThat(readings.placedAt()).contains(new Pose(-1, -2, 180));
    }

    @Test
    void aPlacedRobotStaysWhereItWasWhenItsOdometryStartsAgain() {
        reported(Pose.START);
        readings.place(new Pose(1000, 2000, 90), Uncertainty.BY_HAND);
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

    @Test
    void theUncertaintyOfAPlacedRobotGrowsWithItsWayUntilItIsPlacedAgain() {
        reported(new Pose(300, 0, 0));
        assertThat(readings.uncertainty().isKnown()).isFalse();
        readings.place(new Pose(0, 0, 90), Uncertainty.of(10, 1));
        reported(new Pose(2300, 0, 0));

        assertThat(readings.uncertainty().sigmaMm()).isGreaterThan(100);
        assertThat(readings.uncertainty()).isEqualTo(Uncertainty.of(10, 1).after(90, new Pose(2000, 0, 0)));
        readings.place(new Pose(0, 2000, 90), Uncertainty.of(10, 1));
        assertThat(readings.uncertainty()).isEqualTo(Uncertainty.of(10, 1));
    }

    private Pose reported(Pose odometry) {
        readings.report(new BotState(odometry, 0, 0, false, 1), 3);
        return readings.state().pose();
    }

    private static void assertSame(Pose pose, Pose expected) {
        assertThat(pose.xMm()).isCloseTo(expected.xMm(), within(1e-6));
        assertThat(pose.yMm()).isCloseTo(expected.yMm(), within(1e-6));
        assertThat(Pose.normalised(pose.headingDeg() - expected.headingDeg())).isCloseTo(0, within(1e-6));
    }
}

package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import majic.bot.BotState;
import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class PoseHistoryTest {
    private static final double LONGEST_S = 0.5;

    private final PoseHistory history = new PoseHistory();

    private void add(double seconds, Pose pose, double mmPerSec, double degPerSec) {
        history.add(new BotState(pose, mmPerSec, degPerSec, true, nanos(seconds)));
    }

    private Optional<Pose> at(double seconds) {
        return history.at(nanos(seconds), LONGEST_S);
    }

    private static long nanos(double seconds) {
        return Math.round(seconds * 1e9);
    }

    private static void assertNear(Optional<Pose> found, double xMm, double yMm, double headingDeg) {
        Pose pose = found.orElseThrow();
        assertThat(pose.distanceMm(new Pose(xMm, yMm, 0))).isCloseTo(0, within(1e-6));
        assertThat(Pose.normalised(pose.headingDeg() - headingDeg)).isCloseTo(0, within(1e-6));
    }

    @Test
    void betweenTwoStatesThePoseIsBetweenTheirsByTheShorterTurn() {
        add(10, new Pose(100, 0, 170), 0, 0);
        add(10.1, new Pose(140, 20, -170), 0, 0);

        assertNear(at(10.025), 110, 5, 175);
        assertNear(at(10), 100, 0, 170);
    }

    @Test
    void afterTheNewestStateItsVelocitiesAreContinuedForAShortTime() {
        add(10, new Pose(100, 0, 0), 200, 0);

        assertNear(at(10.1), 120, 0, 0);
        assertThat(at(10.6)).isEmpty();
    }

    @Test
    void beforeTheOldestStateItsPoseCountsForAShortTime() {
        add(10, new Pose(100, 0, 0), 200, 90);

        assertNear(at(9.9), 100, 0, 0);
        assertThat(at(9.4)).isEmpty();
    }

    @Test
    void statesOfMoreThanASecondAgoAreForgotten() {
        add(10, new Pose(1, 0, 0), 0, 0);
        add(10.9, new Pose(2, 0, 0), 0, 0);
        add(11.5, new Pose(3, 0, 0), 0, 0);

        assertNear(at(10.5), 2, 0, 0);
        assertThat(at(10)).isEmpty();
    }

    @Test
    void withoutAStateThereIsNoPose() {
        assertThat(at(1)).isEmpty();
    }

    @Test
    void aBaseThatReportsNothingAtRestStaysWhereItIsIfTheCallerSaysSo() {
        add(10, new Pose(100, 0, 0), 0, 0);

        assertThat(history.at(nanos(1000), Double.POSITIVE_INFINITY)).contains(new Pose(100, 0, 0));
    }
}

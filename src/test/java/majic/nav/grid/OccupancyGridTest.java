package majic.nav.grid;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Pose;
import majic.nav.grid.OccupancyGrid.State;
import org.junit.jupiter.api.Test;

class OccupancyGridTest {
    /** Four metres by two from (0, 0), free, with a wall along its right end. */
    private static final OccupancyGrid ROOM =
            OccupancyGrid.of(Pose.START, 100, 40, 20, (column, row) -> column == 39 ? 0.9 : 0.1);

    @Test
    void aCircleIsFreeOnlyIfAllOfItIsKnownToBe() {
        assertThat(ROOM.isFree(1000, 1000, 500)).isTrue();
        assertThat(ROOM.isFree(3600, 1000, 500)).isFalse();
        assertThat(ROOM.isFree(200, 1000, 500)).as("unknown beyond the edge").isFalse();
    }

    @Test
    void theNearestObstacleIsFoundWithinAReach() {
        assertThat(ROOM.obstacleMm(1050, 1050, 5000)).isEqualTo(2900);
        assertThat(ROOM.obstacleMm(1050, 1050, 2000)).isInfinite();
    }

    @Test
    void joinedGridsKnowWhatBothKnow() {
        OccupancyGrid turned =
                OccupancyGrid.of(new Pose(4000, 3000, 90), 100, 20, 20, (column, row) -> row == 0 ? 0.9 : 0.1);

        OccupancyGrid both = ROOM.joined(turned);

        assertThat(both.stateAt(1050, 1050)).isEqualTo(State.FREE);
        assertThat(both.stateAt(3950, 1050)).isEqualTo(State.OCCUPIED);
        assertThat(both.stateAt(3950, 4050))
                .as("the first row of the turned grid")
                .isEqualTo(State.OCCUPIED);
        assertThat(both.stateAt(3050, 4050)).isEqualTo(State.FREE);
        assertThat(both.stateAt(1050, 4050)).isEqualTo(State.UNKNOWN);
    }

    @Test
    void evidenceOfBothIsAdded() {
        OccupancyGrid half = OccupancyGrid.of(Pose.START, 100, 1, 1, (column, row) -> 0.4);
        OccupancyGrid against = OccupancyGrid.of(Pose.START, 100, 1, 1, (column, row) -> 0.6);

        assertThat(half.joined(against).probability(0, 0)).isEqualTo(0.5);
        assertThat(half.joined(half).probability(0, 0)).isLessThan(0.4);
    }
}

package majic.nav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import majic.bot.Pose;
import majic.nav.grid.OccupancyGrid;
import org.junit.jupiter.api.Test;

/** A room of two by two metres with walls around it, of which only the left half is known. */
class FrontiersTest {
    private static final double WIDTH_MM = 400;

    private static OccupancyGrid room(double knownToMm) {
        return OccupancyGrid.of(Pose.START, 50, 40, 40, (column, row) -> {
            if (column * 50 >= knownToMm) {
                return Double.NaN;
            }
            return column == 0 || row == 0 || row == 39 ? 0.9 : 0.1;
        });
    }

    @Test
    void theKnownFloorEndsAtAFrontier() {
        Frontiers frontiers = new Frontiers(room(1000), WIDTH_MM);

        assertThat(frontiers.isNear(new Pose(975, 975, 0), 10)).isTrue();
        assertThat(frontiers.isNear(new Pose(500, 975, 0), 300)).isFalse();
    }

    @Test
    void fromNearbyItIsSeenWithTheDirectionToTheUnknown() {
        Frontiers.Views views = new Frontiers(room(1000), WIDTH_MM).views(place -> true, 300);

        Optional<Pose> seen = views.from(new Pose(725, 975, 0));
        assertThat(seen).hasValueSatisfying(frontier -> {
            assertThat(frontier.xMm()).isEqualTo(975);
            assertThat(frontier.headingDeg()).isZero();
        });
        assertThat(views.from(new Pose(325, 975, 0))).isEmpty();
        assertThat(views.from(new Pose(-500, 975, 0))).isEmpty();
    }

    @Test
    void oneThatIsNotWantedIsNotSeen() {
        Frontiers.Views views = new Frontiers(room(1000), WIDTH_MM).views(place -> place.yMm() > 1500, 300);

        assertThat(views.from(new Pose(975, 975, 0))).isEmpty();
        assertThat(views.from(new Pose(975, 1600, 0))).isPresent();
    }

    @Test
    void oneShorterThanARobotIsLeftOut() {
        assertThat(new Frontiers(room(1000), 2000).isNear(new Pose(975, 975, 0), 500))
                .isFalse();
    }
}

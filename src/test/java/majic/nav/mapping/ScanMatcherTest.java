package majic.nav.mapping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.mapping.ReferenceGrid.PlacedPoints;
import org.junit.jupiter.api.Test;

class ScanMatcherTest {
    private static final Pose CORNER = new Pose(21_000, 0, 20);
    private final Floor floor = Floor.ring(3);

    private EchoPoints points(Pose truth) {
        return EchoPoints.of(floor.scan(Floor.LASER, 0, truth, truth));
    }

    private ReferenceGrid reference(int levels) {
        return new ReferenceGrid(
                List.of(
                        new PlacedPoints(points(CORNER), CORNER),
                        new PlacedPoints(points(CORNER.plus(new Pose(200, 0, 0))), CORNER.plus(new Pose(200, 0, 0)))),
                levels);
    }

    @Test
    void aScanIsFoundFromAWrongPredictionToACentimetre() {
        Pose truth = new Pose(21_100, 60, 35);
        SearchWindow window = new SearchWindow(new Pose(20_800, -200, 20), 300, 10);

        Optional<ScanMatch> match = ScanMatcher.match(reference(5), points(truth), window, Information.NONE, 0.3);

        assertThat(match).isPresent();
        assertThat(match.get().pose().distanceMm(truth)).isLessThan(15);
        assertThat(match.get().pose().headingDeg()).isCloseTo(35, within(0.3));
        assertThat(match.get().response()).isGreaterThan(0.8);
    }

    @Test
    void blocksOfEachSizeLeadToTheSamePose() {
        Pose truth = new Pose(21_100, 60, 35);
        SearchWindow window = new SearchWindow(new Pose(20_900, -100, 30), 150, 4);
        Pose plain =
                CorrelativeSearch.best(reference(0), points(truth), window, 0.1).orElseThrow();
        for (int levels = 1; levels <= 6; levels++) {
            assertThat(CorrelativeSearch.best(reference(levels), new Floors().same(truth), window, 0.1))
                    .map(pose -> pose.distanceMm(plain) < 75)
                    .contains(true);
        }
    }

    /** Scans without the noise that an earlier one has used up. */
    private static final class Floors {
        EchoPoints same(Pose truth) {
            return EchoPoints.of(Floor.ring(3).scan(Floor.LASER, 0, truth, truth));
        }
    }

    @Test
    void aStraightCorridorSaysNothingOfThePlaceAlongIt() {
        Pose middle = new Pose(50_000, 0, 0);
        float[] ranges = new float[181];
        for (int index = 0; index < ranges.length; index++) {
            ranges[index] = (float) (1000 / Math.abs(Math.sin(Math.toRadians(index - 90))));
        }
        EchoPoints corridor = EchoPoints.of(new RangeScan(Floor.LASER, 0, middle, ranges));
        ReferenceGrid reference = new ReferenceGrid(List.of(new PlacedPoints(corridor, middle)), 3);

        ScanMatch match = ScanMatcher.refine(reference, corridor, middle, middle, Information.NONE)
                .orElseThrow();

        assertThat(match.covariance().xx())
                .isGreaterThan(30 * match.covariance().yy());
    }

    /** The wall is 150 mm thick. */
    @Test
    void theTwoSidesOfAWallAreNotTakenForOneSurface() {
        Pose below = new Pose(50_000, 0, 90);
        Pose above = new Pose(50_000, 2150, -90);
        ReferenceGrid reference = new ReferenceGrid(List.of(new PlacedPoints(wallAhead(below, 1000), below)), 3);

        ScanMatch other = ScanMatcher.refine(reference, wallAhead(above, 1000), above, above, Information.NONE)
                .orElseThrow();
        ScanMatch same = ScanMatcher.refine(reference, wallAhead(below, 850), below, below, Information.NONE)
                .orElseThrow();

        assertThat(other.pose().distanceMm(above)).isLessThan(1);
        assertThat(other.response()).isZero();
        assertThat(same.pose().distanceMm(below)).isCloseTo(150, within(1.0));
        assertThat(same.response()).isGreaterThan(0.9);
    }

    private static EchoPoints wallAhead(Pose at, double mm) {
        float[] ranges = new float[Floor.LASER.beams().size()];
        for (int index = 0; index < ranges.length; index++) {
            int angle = index - 90;
            ranges[index] =
                    Math.abs(angle) > 40 ? Float.POSITIVE_INFINITY : (float) (mm / Math.cos(Math.toRadians(angle)));
        }
        return EchoPoints.of(new RangeScan(Floor.LASER, 0, at, ranges));
    }

    @Test
    void aScanOfAnotherPlaceIsNotFound() {
        EchoPoints elsewhere = points(new Pose(8000, 16_000, 180));

        assertThat(ScanMatcher.match(reference(5), elsewhere, new SearchWindow(CORNER, 100, 5), Information.NONE, 0.4)
                        .filter(match -> match.response() > 0.6))
                .isEmpty();
    }
}

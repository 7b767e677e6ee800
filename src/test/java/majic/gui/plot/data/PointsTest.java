package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PointsTest {
    private static final Span TEN_SECONDS = new Span(0, 10);
    private static final int COLUMNS = 10;

    private static Points wave(int count) {
        double[] times = IntStream.range(0, count)
                .mapToDouble(index -> 10.0 * index / count)
                .toArray();
        return new Points(times, Arrays.stream(times).map(Math::sin).toArray());
    }

    @Test
    void fewPointsAreNotThinned() {
        Points few = wave(COLUMNS);
        assertThat(few.thinned(TEN_SECONDS, COLUMNS)).isSameAs(few);
    }

    @Test
    void atMostFivePointsAColumnRemain() {
        assertThat(wave(10_000).thinned(TEN_SECONDS, COLUMNS).size()).isBetween(COLUMNS, 5 * COLUMNS);
    }

    @Test
    void theLowestAndTheHighestValuesRemain() {
        Points all = wave(10_000);
        all.values()[4321] = 99;
        all.values()[8765] = -99;
        Points thinned = all.thinned(TEN_SECONDS, COLUMNS);
        assertThat(thinned.values()).contains(99, -99);
        assertThat(thinned.times()).contains(all.times()[4321], all.times()[8765]);
    }

    @Test
    void timesStayInOrder() {
        assertThat(wave(10_000).thinned(TEN_SECONDS, COLUMNS).times()).isSorted();
    }

    @Test
    void anInterruptionRemains() {
        Points all = wave(10_000);
        all.values()[5500] = Double.NaN;
        assertThat(all.thinned(TEN_SECONDS, COLUMNS).values()).contains(Double.NaN);
    }

    @Test
    void aRecordedValueHoldsUntilShortlyBeforeTheNextChange() {
        Points points = Points.ofChanges(new double[] {0, 5, 5.1}, new double[] {1, 2, Double.POSITIVE_INFINITY}, 0.1);
        assertThat(points.times()).containsExactly(0, 4.9, 5, 5.1);
        assertThat(points.values()).containsExactly(1, 1, 2, Double.NaN);
    }

    @Test
    void aHorizontalPieceHasOnlyItsEnds() {
        double none = Double.NaN;
        Points points =
                new Points(new double[] {0, 1, 2, 3, 4, 5, 6, 7, 8}, new double[] {1, 1, 1, 1, 2, none, none, 1, 1});
        assertThat(points.withoutRepeats().times()).containsExactly(0, 3, 4, 5, 6, 7, 8);
    }
}

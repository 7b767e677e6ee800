package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SamplesTest {
    private static final Span EVERYTHING = new Span(-1e9, 1e9);

    private final Samples samples = new Samples();

    private void addOnePerSecond(int count) {
        for (int second = 0; second < count; second++) {
            samples.add(second, 10 * second);
        }
    }

    @Test
    void theNewestReadingsAreKeptWhenThereIsNoMoreRoom() {
        addOnePerSecond(Samples.MOST + 3);
        Points all = samples.within(EVERYTHING);
        assertThat(all.size()).isEqualTo(Samples.MOST);
        assertThat(all.times()[0]).isEqualTo(3);
        assertThat(samples.newest()).isEqualTo(10.0 * (Samples.MOST + 2));
    }

    @Test
    void aSpanContainsItsEnds() {
        addOnePerSecond(10);
        assertThat(samples.within(new Span(3, 5)).times()).containsExactly(3, 4, 5);
    }

    @Test
    void aCurveReachesTheEdgesOfASpan() {
        addOnePerSecond(10);
        assertThat(samples.around(new Span(3.5, 4.5)).times()).containsExactly(3, 4, 5);
    }

    @Test
    void aValueHoldsUntilTheNextReading() {
        addOnePerSecond(3);
        assertThat(samples.at(1.9)).isEqualTo(10);
        assertThat(samples.at(-0.1)).isNaN();
        assertThat(samples.at(99)).isEqualTo(20);
    }

    @Test
    void pastReadingsComeBeforeTheFirstOne() {
        samples.add(5, 50);
        samples.addPast(new Points(new double[] {3, 4, 6}, new double[] {30, 40, 60}));
        assertThat(samples.within(EVERYTHING).values()).containsExactly(30, 40, 40, 50);
        assertThat(samples.newest()).isEqualTo(50);
    }

    @Test
    void theLastPastReadingHoldsUntilTheFirstOne() {
        samples.add(60, 50);
        samples.addPast(new Points(new double[] {3}, new double[] {30}));
        assertThat(samples.at(59.9)).isEqualTo(30);
        assertThat(samples.within(new Span(59.9, 60)).values()).containsExactly(30, 50);
    }

    @Test
    void pastReadingsAreAcceptedBeforeThereIsAnother() {
        samples.addPast(new Points(new double[] {3, 4}, new double[] {30, 40}));
        assertThat(samples.within(EVERYTHING).values()).containsExactly(30, 40);
    }

    @Test
    void timeDoesNotGoBack() {
        samples.add(5, 50);
        samples.add(4, 40);
        assertThat(samples.within(EVERYTHING).times()).containsExactly(5, 5);
    }
}

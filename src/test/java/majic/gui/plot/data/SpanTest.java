package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpanTest {
    @ParameterizedTest
    @CsvSource({"0, 100", "-3, 7", "2843, 2886", "0.001, 0.002", "5, 5", "0, 0", "-1e6, -1e6"})
    void anAxisLeavesRoomAroundTheValues(double least, double greatest) {
        Span axis = Span.ofAxis(least, greatest);
        assertThat(axis.from()).isLessThan(least);
        assertThat(axis.to()).isGreaterThan(greatest);
        assertThat(axis.length()).isLessThan(4 * Math.max(greatest - least, Math.abs(least) * 0.1 + 1));
    }

    @Test
    void aDifferenceThatARecordingDoesNotKeepFillsOnlyAPartOfTheAxis() {
        assertThat(Span.ofAxis(125.9, 125.947).length()).isBetween(0.2, 0.5);
    }

    @Test
    void anAxisChangesOnlyWhenValuesComeNearItsEnds() {
        assertThat(Span.ofAxis(0, 100.5)).isEqualTo(Span.ofAxis(0, 100));
    }

    @Test
    void aScaledSpanKeepsTheNumberInItsMiddleInPlace() {
        assertThat(new Span(0, 10).scaled(0.5, 4)).isEqualTo(new Span(2, 7));
    }

    @Test
    void aPartIsTheSameInBothDirections() {
        assertThat(new Span(100, 200).part(0.75, 0.25)).isEqualTo(new Span(125, 175));
    }
}

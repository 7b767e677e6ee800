package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import majic.bot.Unit;
import majic.gui.plot.data.Computation.Operation;
import org.junit.jupiter.api.Test;

class ComputationTest {
    private static final Span ALL = new Span(0, 10);

    private final Samples a = samples(0, 10, 1, 20, 2, 40, 3, 80);
    private final Samples b = samples(0.5, 1, 2.5, 2);

    private static Samples samples(double... timesAndValues) {
        Samples samples = new Samples();
        for (int index = 0; index < timesAndValues.length; index += 2) {
            samples.add(timesAndValues[index], timesAndValues[index + 1]);
        }
        return samples;
    }

    private static Computation unary(Operation operation, Unit unit, Samples of, double number) {
        return new Computation(operation, List.of("1 x"), List.of(unit), List.of(of), number);
    }

    private Computation binary(Operation operation, Unit other) {
        return new Computation(operation, List.of("1 x", "2 x"), List.of(Unit.MM, other), List.of(a, b), 0);
    }

    @Test
    void aSumHasAValueWheneverOneOfItsCurvesChanges() {
        Points sum = binary(Operation.SUM, Unit.MM).within(ALL);
        assertThat(sum.times()).containsExactly(0, 0.5, 1, 2, 2.5, 3);
        assertThat(sum.values()).containsExactly(Double.NaN, 11, 21, 41, 42, 82);
    }

    @Test
    void aDifferenceOfTwoUnitsHasNone() {
        Computation difference = binary(Operation.DIFFERENCE, Unit.DEG);
        assertThat(difference.at(3)).isEqualTo(78);
        assertThat(difference.quantity().label()).isEqualTo("1 x \u2212 2 x");
        assertThat(binary(Operation.DIFFERENCE, Unit.MM).quantity().unit()).isEqualTo(Unit.MM);
    }

    @Test
    void aDerivativeIsTheChangeOfASecondInItsUnit() {
        Computation derivative = unary(Operation.DERIVATIVE, Unit.MM, a, 0);
        assertThat(derivative.within(ALL).times()).containsExactly(0.3, 1, 1.3, 2, 2.3, 3);
        assertThat(derivative.within(ALL).values()).containsExactly(10, 10, 20, 20, 40, 40);
        assertThat(derivative.at(2.1)).isEqualTo(20);
        assertThat(derivative.quantity().unit()).isEqualTo(Unit.MM_PER_S);
        assertThat(derivative.around(new Span(1.1, 1.2)).values()).containsExactly(10, 20);
    }

    @Test
    void reportsThatFollowEachOtherAtOnceGiveNoPeak() {
        Samples jitter = samples(0, 0, 0.2, 20, 0.201, 30, 0.4, 40, 0.6, 60);
        double[] slopes =
                unary(Operation.DERIVATIVE, Unit.MM, jitter, 0).within(ALL).values();
        assertThat(Arrays.stream(slopes)).allMatch(slope -> slope > 50 && slope < 150);
    }

    @Test
    void aSmoothedCurveIsTheMeanOfTheSecondsBeforeAndKeepsGaps() {
        Samples gap = samples(0, 10, 1, 20, 2, Double.NaN, 3, 80);
        assertThat(unary(Operation.SMOOTHED, Unit.MM, a, 1).within(ALL).values())
                .containsExactly(10, 15, 30, 60);
        assertThat(unary(Operation.SMOOTHED, Unit.MM, gap, 9).within(ALL).values())
                .containsExactly(10, 15, Double.NaN, 80);
    }

    @Test
    void aScaledCurveIsMultipliedAndBeginsWithItsCurve() {
        Computation scaled = unary(Operation.SCALE, Unit.MM, a, 0.5);
        assertThat(Arrays.stream(scaled.within(ALL).values()).sum()).isEqualTo(75);
        assertThat(scaled.start()).isEqualTo(0);
        assertThat(scaled.quantity().title()).isEqualTo("0.5 \u00d7 1 x");
        assertThat(unary(Operation.SCALE, Unit.MM, new Samples(), 2).start()).isNaN();
    }
}

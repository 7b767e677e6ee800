package majic.gui.plot;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Unit;
import majic.gui.plot.data.Quantity;
import org.junit.jupiter.api.Test;

class CurveTest {
    private static final Quantity HEADING = new Quantity(1, "heading", -1, Unit.DEG, false);
    private static final Quantity LIGHT = new Quantity(1, "light", -1, Unit.NONE, true);

    @Test
    void aValueHasItsUnitAndAMinusSign() {
        assertThat(Curve.text(HEADING, -12)).isEqualTo("−12°");
    }

    @Test
    void aSwitchIsOnOrOff() {
        assertThat(Curve.text(LIGHT, 1)).isEqualTo("on");
        assertThat(Curve.text(LIGHT, 0)).isEqualTo("off");
    }

    @Test
    void aGapHasADash() {
        assertThat(Curve.text(HEADING, Double.NaN)).isEqualTo("–");
    }
}

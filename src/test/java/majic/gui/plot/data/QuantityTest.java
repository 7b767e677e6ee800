package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;

class QuantityTest {
    private static final Parameter SPEED = Parameter.number("speed", Unit.MM_PER_S, "how fast");
    private static final Parameter SONAR = Parameter.list("sonar", Unit.MM, "all ranges");
    private static final Parameter LIGHT = Parameter.onOff("light", "whether it is lit");
    private static final Value RANGES = Value.many(List.of(Value.of(500, Unit.MM), Value.CLEAR));

    private static List<Quantity> of(Parameter parameter, Value present) {
        return Quantity.of(1, parameter, present);
    }

    @Test
    void aListHasAQuantityForEachOfItsValues() {
        assertThat(of(SONAR, RANGES)).map(Quantity::label).containsExactly("1 sonar[0] (mm)", "1 sonar[1] (mm)");
    }

    @Test
    void aListWithoutValuesHasNoQuantity() {
        assertThat(of(SONAR, Value.unknown("no reading yet"))).isEmpty();
    }

    @Test
    void nothingInRangeIsNoNumber() {
        Quantity second = of(SONAR, RANGES).get(1);
        assertThat(second.in(RANGES)).isNaN();
    }

    @Test
    void anUnknownValueIsNoNumber() {
        Quantity speed = of(SPEED, Value.of(1, Unit.MM_PER_S)).get(0);
        assertThat(speed.in(Value.unknown("not connected"))).isNaN();
        assertThat(speed.in(Value.of(80, Unit.MM_PER_S))).isEqualTo(80);
    }

    @Test
    void aSwitchIsPlottedAsOneAndZero() {
        Quantity light = of(LIGHT, Value.onOff(true)).get(0);
        assertThat(light.in(Value.onOff(true))).isEqualTo(1);
        assertThat(light.in(Value.onOff(false))).isZero();
    }

    @Test
    void textsAreNotPlottable() {
        assertThat(Quantity.isPlottable(SPEED)).isTrue();
        assertThat(Quantity.isPlottable(SONAR)).isTrue();
        assertThat(Quantity.isPlottable(Parameter.text("version", "the firmware")))
                .isFalse();
    }
}

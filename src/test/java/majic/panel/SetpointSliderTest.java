package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JSlider;
import majic.bot.Parameter;
import majic.bot.Unit;
import org.junit.jupiter.api.Test;

class SetpointSliderTest {
    private final List<String> chosen = new ArrayList<>();
    private final SetpointSlider slider = new SetpointSlider(
            Parameter.number("neck", Unit.DEG, "lowers the neck").within(-79, 2),
            false,
            (value, last) -> chosen.add(value + (last ? " at last" : "")));

    private final JSlider knob = Stream.of(slider.getComponents())
            .filter(JSlider.class::isInstance)
            .map(JSlider.class::cast)
            .findFirst()
            .orElseThrow();

    @Test
    void theKnobFollowsWhatIsMeasuredUntilAValueIsChosen() {
        slider.show("-20 deg", -20.4, false);

        assertThat(knob.getValue()).isEqualTo(-20);
        assertThat(chosen).isEmpty();
    }

    @Test
    void aDragChoosesEachPlaceAndMarksTheLast() {
        knob.setValueIsAdjusting(true);
        knob.setValue(-10);
        knob.setValue(-30);
        knob.setValueIsAdjusting(false);

        assertThat(chosen).containsExactly("0.0", "-10.0", "-30.0", "-30.0 at last");
    }

    @Test
    void aNotchOfTheWheelMovesTheKnobByOneUnit() {
        knob.dispatchEvent(new MouseWheelEvent(
                knob, MouseEvent.MOUSE_WHEEL, 0, 0, 1, 1, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, 1));

        assertThat(chosen).containsExactly("-1.0 at last");
    }

    @Test
    void theToolTipNamesTheStepOfKeysAndWheel() {
        assertThat(knob.getToolTipText()).isEqualTo("lowers the neck. Arrow keys and wheel: 1°. In commands: neck");
    }

    @Test
    void aHeldKnobStaysWhereItIsHeld() {
        knob.setValueIsAdjusting(true);
        knob.setValue(-30);
        slider.show("-5 deg", -5.0, false);

        assertThat(knob.getValue()).isEqualTo(-30);
    }

    @Test
    void theKnobStaysOnWhatWasChosenUntilItHasComeAbout() {
        knob.setValue(-30);
        slider.show("-5 deg", -5.0, true);
        assertThat(knob.getValue()).isEqualTo(-30);
        slider.show("-29 deg", -29.0, false);

        assertThat(knob.getValue()).isEqualTo(-29);
    }

    @Test
    void whatIsNotMeasuredLeavesTheKnobAlone() {
        slider.show("-20 deg", -20.0, false);
        slider.show("–", null, false);

        assertThat(knob.getValue()).isEqualTo(-20);
    }
}

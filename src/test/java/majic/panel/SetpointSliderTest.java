package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import org.junit.jupiter.api.Test;

class SetpointSliderTest {
    private final List<String> wishes = new ArrayList<>();
    private final SetpointSlider slider = new SetpointSlider(
            Parameter.number("neck", Unit.DEG, "lowers the neck").within(-79, 2),
            false,
            (value, last) -> wishes.add(value + (last ? " at last" : "")));

    @Test
    void theKnobFollowsWhatIsMeasuredWithoutAWish() {
        slider.show("-20 deg", -20.4, false);

        assertThat(slider.slider().getValue()).isEqualTo(-20);
        assertThat(wishes).isEmpty();
    }

    @Test
    void aDragChoosesEachPlaceAndMarksTheLast() {
        slider.slider().setValueIsAdjusting(true);
        slider.slider().setValue(-10);
        slider.slider().setValue(-30);
        slider.slider().setValueIsAdjusting(false);

        assertThat(wishes).containsExactly("0.0", "-10.0", "-30.0", "-30.0 at last");
    }

    @Test
    void aHeldKnobStaysWhereItIsHeld() {
        slider.slider().setValueIsAdjusting(true);
        slider.slider().setValue(-30);
        slider.show("-5 deg", -5.0, false);

        assertThat(slider.slider().getValue()).isEqualTo(-30);
    }

    @Test
    void theKnobStaysOnWhatWasChosenUntilItHasComeAbout() {
        slider.slider().setValue(-30);
        slider.show("-5 deg", -5.0, true);
        assertThat(slider.slider().getValue()).isEqualTo(-30);
        slider.show("-29 deg", -29.0, false);

        assertThat(slider.slider().getValue()).isEqualTo(-29);
    }

    @Test
    void whatIsNotMeasuredLeavesTheKnobAlone() {
        slider.show("-20 deg", -20.0, false);
        slider.show("–", null, false);

        assertThat(slider.slider().getValue()).isEqualTo(-20);
    }
}

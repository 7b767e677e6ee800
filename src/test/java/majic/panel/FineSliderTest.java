package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JSlider;
import javax.swing.LookAndFeel;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class FineSliderTest {
    private static final int HEIGHT = 20;

    private final LookAndFeel look = UIManager.getLookAndFeel();

    @BeforeEach
    void useFlatLaf() {
        FlatLightLaf.setup();
    }

    @AfterEach
    void restoreLook() throws Exception {
        UIManager.setLookAndFeel(look);
    }

    private static JSlider slider(int width) {
        JSlider slider = new FineSlider(-91, 91);
        slider.setSize(width, HEIGHT);
        return slider;
    }

    /** Drags from the middle, where the knob is. */
    private static void drag(JSlider slider, int pixels) {
        int middle = slider.getWidth() / 2;
        send(slider, MouseEvent.MOUSE_PRESSED, middle);
        send(slider, MouseEvent.MOUSE_DRAGGED, middle + pixels);
        send(slider, MouseEvent.MOUSE_RELEASED, middle + pixels);
    }

    private static void send(JSlider slider, int kind, int x) {
        slider.dispatchEvent(new MouseEvent(
                slider, kind, 0, MouseEvent.BUTTON1_DOWN_MASK, x, HEIGHT / 2, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void aDragByAPixelMovesTheKnobOfAShortSliderByOneUnit() {
        JSlider slider = slider(60);
        int before = slider.getValue();
        drag(slider, 1);

        assertThat(slider.getValue()).isEqualTo(before + 1);
    }

    @Test
    void aDragBeyondTheEndOfAShortSliderReachesItsLastValue() {
        JSlider slider = slider(60);
        slider.setInverted(true);
        drag(slider, 120);

        assertThat(slider.getValue()).isEqualTo(-91);
    }

    @Test
    void theKnobOfALongSliderFollowsTheMouse() {
        JSlider slider = slider(1000);
        drag(slider, 250);

        assertThat(slider.getValue()).isBetween(44, 48);
    }

    @Test
    void aDragIsOverWhenTheButtonIsReleased() {
        JSlider slider = slider(60);
        List<Boolean> adjusting = new ArrayList<>();
        slider.addChangeListener(change -> adjusting.add(slider.getValueIsAdjusting()));
        drag(slider, 5);

        assertThat(adjusting).contains(true).endsWith(false);
    }
}

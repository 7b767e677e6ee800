package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import majic.gui.Contrast;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that drawings in the colours of the look and feel are readable, in the light look and in the dark one. */
class DrawingColorsTest {
    static Stream<FlatLaf> looks() {
        return Stream.of(new FlatLightLaf(), new FlatDarkLaf());
    }

    @AfterEach
    void leaveTheUsualLook() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
    }

    @ParameterizedTest
    @MethodSource("looks")
    void wordsAndFiguresCanBeReadInBothLooks(FlatLaf look) throws Exception {
        DrawingColors colors = colorsOf(look);

        assertThat(Contrast.of(colors.line(), colors.paper())).isGreaterThanOrEqualTo(Contrast.TEXT);
        assertThat(Contrast.of(colors.alarm(), colors.paper())).isGreaterThanOrEqualTo(Contrast.TEXT);
    }

    @ParameterizedTest
    @MethodSource("looks")
    void shapesStandOutInBothLooks(FlatLaf look) throws Exception {
        DrawingColors colors = colorsOf(look);
        assertThat(Contrast.of(colors.accent(), colors.paper())).isGreaterThanOrEqualTo(Contrast.SHAPES);
    }

    private static DrawingColors colorsOf(FlatLaf look) throws Exception {
        DrawingColors[] colors = new DrawingColors[1];
        SwingUtilities.invokeAndWait(() -> {
            FlatLaf.setup(look);
            colors[0] = DrawingColors.current();
        });
        return colors[0];
    }
}

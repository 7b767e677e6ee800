package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that drawings in the colours of the look and feel are readable, in the light look and in the dark one. */
class DrawingColorsTest {
    /** WCAG 2.1, success criterion 1.4.3: minimum contrast of text. */
    private static final double TEXT = 4.5;

    /** WCAG 2.1, success criterion 1.4.11: minimum contrast of graphics. */
    private static final double SHAPES = 3;

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

        assertThat(contrast(colors.line(), colors.paper())).isGreaterThanOrEqualTo(TEXT);
        assertThat(contrast(colors.alarm(), colors.paper())).isGreaterThanOrEqualTo(TEXT);
    }

    @ParameterizedTest
    @MethodSource("looks")
    void shapesStandOutInBothLooks(FlatLaf look) throws Exception {
        DrawingColors colors = colorsOf(look);
        assertThat(contrast(colors.accent(), colors.paper())).isGreaterThanOrEqualTo(SHAPES);
    }

    private static DrawingColors colorsOf(FlatLaf look) throws Exception {
        DrawingColors[] colors = new DrawingColors[1];
        SwingUtilities.invokeAndWait(() -> {
            FlatLaf.setup(look);
            colors[0] = DrawingColors.current();
        });
        return colors[0];
    }

    /** Returns the contrast ratio of WCAG 2.1: 1 to 21. */
    private static double contrast(Color one, Color other) {
        double a = luminance(one) + 0.05;
        double b = luminance(other) + 0.05;
        return Math.max(a, b) / Math.min(a, b);
    }

    private static double luminance(Color color) {
        return 0.2126 * linear(color.getRed()) + 0.7152 * linear(color.getGreen()) + 0.0722 * linear(color.getBlue());
    }

    private static double linear(int channel) {
        double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}

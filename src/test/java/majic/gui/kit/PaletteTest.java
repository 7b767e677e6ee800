package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.gui.Contrast;
import majic.panel.DrawingColors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that the colours with a meaning can be read on all surfaces, in the light look and in the dark one. */
class PaletteTest {
    static Stream<FlatLaf> looks() {
        return Stream.of(new FlatLightLaf(), new FlatDarkLaf());
    }

    @AfterEach
    void leaveTheUsualLook() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
    }

    @ParameterizedTest
    @MethodSource("looks")
    void textsCanBeReadOnEverySurface(FlatLaf look) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            FlatLaf.setup(look);
            for (Color text : List.of(Palette.text(), Palette.faint(), Palette.command(), Palette.error())) {
                assertContrast(text, Contrast.TEXT);
            }
        });
    }

    @ParameterizedTest
    @MethodSource("looks")
    void shapesStandOutOnEverySurface(FlatLaf look) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            FlatLaf.setup(look);
            DrawingColors colors = DrawingColors.current();
            for (Color shape : List.of(Palette.shape(), Palette.forbidden(), colors.good(), colors.accent())) {
                assertContrast(shape, Contrast.SHAPES);
            }
        });
    }

    private static void assertContrast(Color color, double least) {
        for (String surface : List.of("Panel.background", "TextPane.background", "TextArea.background")) {
            assertThat(Contrast.of(color, UIManager.getColor(surface)))
                    .as(String.format("%06x on %s", color.getRGB() & 0xFFFFFF, surface))
                    .isGreaterThanOrEqualTo(least);
        }
    }
}

package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EditorColorsTest {
    private static final double LEAST_CONTRAST = 4.5;

    @AfterEach
    void restoreLook() {
        FlatLightLaf.setup();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void everyColourIsReadableAlsoInLinesThatRun(boolean dark) {
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        EditorColors colors = EditorColors.current();
        for (Color background : List.of(colors.paper(), colors.running(), colors.next())) {
            colors.types()
                    .forEach((type, color) -> assertThat(contrast(color, background))
                            .as("type %d, %s on %s", type, color, background)
                            .isGreaterThanOrEqualTo(LEAST_CONTRAST));
        }
    }

    private static double contrast(Color one, Color other) {
        double first = luminance(one);
        double second = luminance(other);
        return (Math.max(first, second) + 0.05) / (Math.min(first, second) + 0.05);
    }

    private static double luminance(Color color) {
        double[] parts = DoubleStream.of(color.getRed(), color.getGreen(), color.getBlue())
                .map(part -> part / 255)
                .map(part -> part <= 0.03928 ? part / 12.92 : Math.pow((part + 0.055) / 1.055, 2.4))
                .toArray();
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
    }
}

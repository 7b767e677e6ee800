package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.color.ColorSpace;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the robots of a full team differ visibly in their colours, and that these are visible in both looks. */
class RobotColorsTest {
    private static final int ROBOTS = 20;

    /** The least distance in CIE L*a*b*; about 2 can just be seen side by side. */
    private static final double LEAST_DISTANCE = 18;

    private static final double LEAST_GRAPHICS_CONTRAST = 3;
    private static final double LEAST_TEXT_CONTRAST = 4.5;

    @AfterAll
    static void light() {
        FlatLightLaf.setup();
    }

    private static List<Color> colors(boolean dark) {
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
        return IntStream.rangeClosed(1, ROBOTS).mapToObj(RobotColors::of).toList();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void noTwoRobotsHaveSimilarColors(boolean dark) {
        List<Color> colors = colors(dark);
        for (int one = 0; one < ROBOTS; one++) {
            for (int other = 0; other < one; other++) {
                assertThat(distance(colors.get(one), colors.get(other)))
                        .as("robots %d and %d", one + 1, other + 1)
                        .isGreaterThan(LEAST_DISTANCE);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void eachColorStandsOutFromTheMapTheCardsAndTheWindow(boolean dark) {
        List<Color> colors = colors(dark);
        List<Color> backgrounds = Stream.of("TextArea.background", "TextPane.background", "Panel.background")
                .map(UIManager::getColor)
                .toList();
        for (int robot = 1; robot <= ROBOTS; robot++) {
            for (Color background : backgrounds) {
                assertThat(RobotColors.contrast(colors.get(robot - 1), background))
                        .as("robot %d", robot)
                        .isGreaterThanOrEqualTo(LEAST_GRAPHICS_CONTRAST);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theNumberIsReadableOnEachColor(boolean dark) {
        assertThat(colors(dark))
                .allSatisfy(color -> assertThat(RobotColors.contrast(color, RobotColors.textOn(color)))
                        .isGreaterThanOrEqualTo(LEAST_TEXT_CONTRAST));
    }

    private static double distance(Color one, Color other) {
        double[] first = lab(one);
        double[] second = lab(other);
        return Math.hypot(Math.hypot(first[0] - second[0], first[1] - second[1]), first[2] - second[2]);
    }

    private static double[] lab(Color color) {
        float[] xyz = color.getColorComponents(ColorSpace.getInstance(ColorSpace.CS_CIEXYZ), null);
        double x = root(xyz[0] / 0.9642);
        double y = root(xyz[1]);
        double z = root(xyz[2] / 0.8249);
        return new double[] {116 * y - 16, 500 * (x - y), 200 * (y - z)};
    }

    private static double root(double share) {
        return share > 0.008856 ? Math.cbrt(share) : 7.787 * share + 16.0 / 116;
    }
}

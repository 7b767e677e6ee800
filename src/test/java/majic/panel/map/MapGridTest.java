package majic.panel.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Set;
import java.util.TreeSet;
import majic.panel.DrawingColors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MapGridTest {
    private static final int SIDE = 600;

    @ParameterizedTest
    @CsvSource({"1, 1", "1.25, 1", "1.5, 1", "2, 2"})
    void allLinesHaveTheSameWidthAtAnyScaleOfTheSystem(double scale, int width) {
        BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        pen.scale(scale, scale);
        int side = (int) (SIDE / scale);
        MapView view = new MapView(0.0913, 7, 11, MapView.Y_UP, side, side);
        new MapGrid(pen, view, new DrawingColors(Color.WHITE, Color.BLACK, Color.BLUE, Color.RED)).paintLines();
        pen.dispose();

        assertThat(widths(image, 5)).containsExactly(width);
    }

    /** Returns the widths of the lines that cross a row of pixels. */
    private static Set<Integer> widths(BufferedImage image, int y) {
        Set<Integer> widths = new TreeSet<>();
        int black = Color.BLACK.getRGB();
        for (int x = 1; x < SIDE; x++) {
            if (image.getRGB(x, y) != black && image.getRGB(x - 1, y) == black) {
                int end = x;
                while (end < SIDE && image.getRGB(end, y) != black) {
                    end++;
                }
                widths.add(end - x);
            }
        }
        return widths;
    }
}

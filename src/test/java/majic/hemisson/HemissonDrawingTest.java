package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import majic.bot.BotState;
import org.junit.jupiter.api.Test;

class HemissonDrawingTest {
    private static final int SIZE = 400;

    @Test
    void aNearThingFillsItsBar() {
        int[] far = painted(new Proximity(List.of(0, 0, 0, 0, 0, 0, 0, 0)));
        int[] near = painted(new Proximity(List.of(255, 0, 0, 0, 0, 0, 0, 0)));

        assertThat(coloured(near)).isGreaterThan(coloured(far) + 500);
    }

    @Test
    void paintsBeforeTheFirstReading() {
        assertThat(coloured(painted(null))).isPositive();
    }

    private static int[] painted(Proximity seen) {
        HemissonDrawing drawing = new HemissonDrawing(new HemissonView(
                true, seen, Wheels.STILL, BotState.UNKNOWN, Leds.OFF, false, List.of(), LinkQuality.NONE));
        drawing.setSize(SIZE, SIZE);
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_ARGB);
        Graphics2D canvas = image.createGraphics();
        drawing.paint(canvas);
        canvas.dispose();
        return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
    }

    private static long coloured(int[] pixels) {
        long count = 0;
        for (int pixel : pixels) {
            count += (pixel >>> 24) > 128 ? 1 : 0;
        }
        return count;
    }
}

package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import majic.bot.BotState;
import org.junit.jupiter.api.Test;

class HemissonDrawingTest {
    private static final int SIZE = 400;

    @Test
    void aNearThingFillsItsBar() {
        int[] far = painted(new Proximity(List.of(0, 0, 0, 0, 0, 0, 0, 0)));
        int[] near = painted(new Proximity(List.of(255, 0, 0, 0, 0, 0, 0, 0)));

        assertThat(differing(near, far)).isGreaterThan(500);
    }

    @Test
    void paintsBeforeTheFirstReading() {
        assertThat(differing(painted(null), new int[SIZE * SIZE])).isPositive();
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

    private static long differing(int[] one, int[] other) {
        return IntStream.range(0, one.length)
                .filter(index -> one[index] != other[index])
                .count();
    }
}

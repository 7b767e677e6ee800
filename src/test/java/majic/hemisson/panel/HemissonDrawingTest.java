package majic.hemisson.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import majic.hemisson.MajicHemisson;
import majic.hemisson.line.MotorValues;
import majic.hemisson.readings.Clearance;
import majic.hemisson.readings.Proximity;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HemissonDrawingTest {
    private static final int SIZE = 496;
    private static final double PX_PER_MM = 2;
    private static final List<Integer> NOTHING = Collections.nCopies(8, 0);
    private static final List<Integer> BRIGHT = Collections.nCopies(8, 0);
    private static final List<Integer> DARK = Collections.nCopies(8, 255);

    @AutoClose
    private final MajicHemisson bot = new MajicHemisson("hemisson://127.0.0.1:1");

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7})
    void aBarFillsFromItsSensorOutward(int sensor) {
        SensorDrawing mount = SensorDrawing.ALL.get(sensor);
        List<Integer> half = new java.util.ArrayList<>(NOTHING);
        half.set(sensor, 128);
        int[] empty = painted(Scenes.seeing(new Proximity(NOTHING), null));
        int[] filled = painted(Scenes.seeing(new Proximity(half), null));

        assertThat(at(filled, mount.along(mount.lengthMm() * 0.4)))
                .isNotEqualTo(at(empty, mount.along(mount.lengthMm() * 0.4)));
        assertThat(at(filled, mount.along(mount.lengthMm() * 0.6)))
                .isEqualTo(at(empty, mount.along(mount.lengthMm() * 0.6)));
    }

    @Test
    void lightIsPaintedYellowAndDarknessGrey() {
        Point2D besideTheFrontBar = new Point2D.Double(90, 9);
        int unknown = at(painted(Scenes.seeing(null, null)), besideTheFrontBar);
        int bright = at(painted(Scenes.seeing(null, BRIGHT)), besideTheFrontBar);
        int dark = at(painted(Scenes.seeing(null, DARK)), besideTheFrontBar);

        assertThat(blue(bright)).isLessThan(red(bright) / 2);
        assertThat(red(dark)).isEqualTo(blue(dark)).isLessThan(red(unknown));
    }

    @Test
    void aWheelIsFilledAheadOrBackward() {
        int[] still = painted(Scenes.driving(MotorValues.STILL));
        int[] turning = painted(Scenes.driving(new MotorValues(-9, 9)));
        Point2D leftBehind = new Point2D.Double(-15, HemissonBodyDrawing.WHEEL_Y_MM);
        Point2D leftAhead = new Point2D.Double(15, HemissonBodyDrawing.WHEEL_Y_MM);
        Point2D rightAhead = new Point2D.Double(15, -HemissonBodyDrawing.WHEEL_Y_MM);

        assertThat(at(turning, leftBehind)).isNotEqualTo(at(still, leftBehind));
        assertThat(at(turning, leftAhead)).isEqualTo(at(still, leftAhead));
        assertThat(at(turning, rightAhead)).isNotEqualTo(at(still, rightAhead));
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16, 24})
    void theFigureOfAWheelIsInsideTheOutline(int width) {
        double foot = HemissonBodyDrawing.WHEEL_HALF_MM * PX_PER_MM + 14;

        double left = HemissonBodyDrawing.insideHull(94, width, foot, PX_PER_MM);

        assertThat(Math.hypot(left + width / 2.0, foot)).isLessThan(Clearance.HULL_MM * PX_PER_MM - 3);
        assertThat(HemissonBodyDrawing.insideHull(-94, width, foot, PX_PER_MM)).isEqualTo(-left);
        assertThat(HemissonBodyDrawing.insideHull(30, width, foot, PX_PER_MM)).isEqualTo(30);
    }

    @Test
    void aSwitchThatReadsZeroIsDown() {
        int[] all = painted(Scenes.withSwitches(Scenes.REMOTE, Scenes.REMOTE));
        int[] moved = painted(Scenes.withSwitches(Scenes.REMOTE, Scenes.DANCE));

        assertThat(differing(all, moved)).isBetween(100L, 1500L);
    }

    @Test
    void aLostRobotIsPaintedPale() {
        int[] here = painted(Scenes.standing(Scenes.WELL));

        assertThat(differing(here, painted(Scenes.standing(Scenes.LOST)))).isGreaterThan(5000);
    }

    @Test
    void theLeftGroundReadingIsCorrectedIfTheLightIsKnown() {
        Proximity seen = new Proximity(List.of(0, 0, 0, 0, 0, 0, 60, 80));
        List<Integer> light = List.of(220, 220, 220, 220, 220, 220, 220, 200);

        assertThat(Scenes.seeing(seen, light).proximity(Proximity.GROUND_LEFT)).isEqualTo(60);
        assertThat(Scenes.seeing(seen, null).proximity(Proximity.GROUND_LEFT)).isEqualTo(80);
    }

    private int[] painted(HemissonScene view) {
        HemissonDrawing drawing =
                new HemissonDrawing(view, new LedSwitch(bot, Runnable::run, lamp -> false, why -> {}));
        drawing.setSize(SIZE, SIZE);
        drawing.doLayout();
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D canvas = image.createGraphics();
        canvas.setColor(java.awt.Color.WHITE);
        canvas.fillRect(0, 0, SIZE, SIZE);
        drawing.paint(canvas);
        canvas.dispose();
        return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
    }

    /** The colour at a place in the robot's frame, mm. */
    private static int at(int[] image, Point2D place) {
        int x = (int) (SIZE / 2.0 - PX_PER_MM * place.getY());
        int y = (int) (SIZE / 2.0 - PX_PER_MM * place.getX());
        return image[y * SIZE + x];
    }

    private static int red(int rgb) {
        return rgb >> 16 & 0xFF;
    }

    private static int blue(int rgb) {
        return rgb & 0xFF;
    }

    private static long differing(int[] one, int[] other) {
        return IntStream.range(0, one.length)
                .filter(index -> one[index] != other[index])
                .count();
    }
}

package majic.aibo.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.RepaintManager;
import majic.aibo.body.Calibration;
import majic.aibo.body.DogState;
import majic.aibo.body.Joint;
import majic.aibo.body.LedNames;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;
import majic.environment.Settings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever moves, shines or is touched can be seen in the drawing, and a lost dog shines no more. */
class DogDrawingTest {
    private static final int WIDTH = 600;
    private static final int HEIGHT = 500;

    private final DogState dog = new DogState(new Calibration(Settings.inMemory(), "host"));
    private final DogDrawing drawing = new DogDrawing(dog);
    private int[] before;

    @BeforeEach
    void paintAQuietDog() {
        drawing.setSize(WIDTH, HEIGHT);
        before = painted();
    }

    @ParameterizedTest
    @EnumSource(Joint.class)
    void everyJointIsDrawnAsItIsMeasured(Joint joint) {
        put(joint.sensor(), joint.range(UrbiVersion.V1_0).max() / 2 - 10);

        assertThat(differing()).isGreaterThan(30);
    }

    @ParameterizedTest
    @EnumSource(names = {"CHIN", "HEAD_TOUCH", "BACK_FRONT", "BACK_MIDDLE", "BACK_REAR"})
    void everyTouchIsShownWhereItIs(Sensor sensor) {
        put(sensor, 30);

        assertThat(differing()).isBetween(30L, 3000L);
    }

    @ParameterizedTest
    @EnumSource(names = {"PAW_LF", "PAW_RF", "PAW_LH", "PAW_RH"})
    void everyPawOnTheGroundIsShown(Sensor sensor) {
        put(sensor, 1);

        assertThat(differing()).isBetween(30L, 3000L);
    }

    static Stream<String> leds() {
        return Stream.concat(LedNames.all().stream(), Stream.of("earL", "earR"));
    }

    @ParameterizedTest
    @MethodSource("leds")
    void everyLedAndEarIsShown(String device) {
        shine(device, 1);

        assertThat(differing()).isGreaterThan(30);
    }

    @Test
    void aDimLedIsPaintedDarkerThanABrightOne() {
        shine("ledF5", 0.3);
        before = painted();
        shine("ledF5", 1);

        assertThat(differing()).isGreaterThan(20);
    }

    @Test
    void aLostDogIsPaintedPaleWithItsLedsOff() {
        drawing.setEnabled(false);
        int[] lost = painted();
        assertThat(differing()).isGreaterThan(1000);
        before = lost;
        shine("ledF5", 1);

        assertThat(differing()).isZero();
    }

    @Test
    void anUnchangedDogIsPaintedTheSameAgain() {
        assertThat(differing()).isZero();
    }

    @Test
    void onlyAChangeThatIsSeenIsPainted() {
        Rectangle all = new Rectangle(WIDTH, HEIGHT);

        assertThat(paintedFor(Sensor.HEAD_PAN, 10, 10.2, 10.4)).containsExactly(all, all);
    }

    @Test
    void aDistanceIsPaintedOnlyInTheViewFromAbove() {
        drawing.refresh();

        assertThat(paintedFor(Sensor.NEAR, 30, 30, 31))
                .hasSize(2)
                .allMatch(area -> area.width < WIDTH && area.height < HEIGHT);
    }

    @Test
    void theNoiseOfTheAccelerationOfADogAtRestIsNotPainted() {
        put(Sensor.ACCEL_X, 0);
        put(Sensor.ACCEL_Y, 0);
        put(Sensor.ACCEL_Z, -9.8);
        drawing.refresh();

        assertThat(paintedFor(Sensor.ACCEL_X, 0.4, -0.4)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"earL", "ledHC"})
    void whatSeveralViewsShowPaintsAllOfThem(String device) {
        drawing.refresh();

        assertThat(paintedFor(amount -> shine(device, amount), 0.2, 0.9))
                .hasSize(2)
                .containsOnly(new Rectangle(WIDTH, HEIGHT));
    }

    static Stream<String> backLeds() {
        return LedNames.all().stream().filter(led -> led.startsWith("ledB"));
    }

    @ParameterizedTest
    @MethodSource("backLeds")
    void anLedOfTheBackIsPaintedOnlyWhereItShinesInTwoViews(String led) {
        drawing.refresh();

        List<Rectangle> areas = paintedFor(amount -> shine(led, amount), 1);

        assertThat(areas).hasSize(2).allMatch(area -> area.width < WIDTH / 3 && area.height < HEIGHT / 3);
        assertThat(differing()).isGreaterThan(30);
        assertThat(differingOutside(areas)).isZero();
    }

    @ParameterizedTest
    @ValueSource(ints = {17, 40, 90})
    void anAreaPaintedAloneLooksAsInTheWholeDrawing(int size) {
        BufferedImage pieces = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < HEIGHT; y += size) {
            for (int x = 0; x < WIDTH; x += size) {
                Graphics pen = pieces.getGraphics();
                pen.setClip(x, y, size, size);
                drawing.paint(pen);
                pen.dispose();
            }
        }

        int[] after = pieces.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
        assertThat(IntStream.range(0, after.length)
                        .filter(pixel -> isSeen(after[pixel], before[pixel]))
                        .count())
                .isLessThan(20);
    }

    /** Whether colours differ by more than the usual rounding of smooth edges, which depends on the clip. */
    private static boolean isSeen(int colour, int other) {
        return IntStream.of(0, 8, 16).anyMatch(bit -> Math.abs((colour >> bit & 0xFF) - (other >> bit & 0xFF)) > 16);
    }

    @ParameterizedTest
    @ValueSource(strings = {"ledF5", "modeR"})
    void anLedOfTheFaceIsPaintedOnlyThere(String led) {
        drawing.refresh();

        assertThat(paintedFor(amount -> shine(led, amount), 0.2, 0.21, 0.9))
                .hasSize(2)
                .allMatch(area -> area.width < WIDTH && area.height < HEIGHT);
    }

    private List<Rectangle> paintedFor(Sensor sensor, double... readings) {
        return paintedFor(reading -> put(sensor, reading), readings);
    }

    /** Returns the areas that are to be painted again after each reading. */
    private List<Rectangle> paintedFor(DoubleConsumer reported, double... readings) {
        RepaintManager usual = RepaintManager.currentManager(drawing);
        List<Rectangle> painted = new ArrayList<>();
        RepaintManager.setCurrentManager(new RepaintManager() {
            @Override
            public void addDirtyRegion(JComponent component, int x, int y, int width, int height) {
                painted.add(new Rectangle(x, y, width, height));
            }
        });
        try {
            for (double reading : readings) {
                reported.accept(reading);
                drawing.refresh();
            }
        } finally {
            RepaintManager.setCurrentManager(usual);
        }
        return painted;
    }

    private void put(Sensor sensor, double amount) {
        dog.senses().put(sensor, new UrbiValue.Num(amount), 1);
    }

    private void shine(String device, double amount) {
        long index = leds().takeWhile(name -> !name.equals(device)).count();
        UrbiMessage.Body body = new UrbiMessage.Result(new UrbiValue.Num(amount));
        dog.leds().take(new UrbiMessage(0, "t_led" + index, body));
    }

    private long differing() {
        int[] after = painted();
        return IntStream.range(0, after.length)
                .filter(pixel -> after[pixel] != before[pixel])
                .count();
    }

    private long differingOutside(List<Rectangle> areas) {
        int[] after = painted();
        return IntStream.range(0, after.length)
                .filter(pixel -> after[pixel] != before[pixel])
                .filter(pixel -> areas.stream().noneMatch(area -> area.contains(pixel % WIDTH, pixel / WIDTH)))
                .count();
    }

    private int[] painted() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        drawing.paint(image.getGraphics());
        return image.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
    }
}

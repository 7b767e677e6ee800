package majic.ros.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.ros.message.Hazard;
import org.junit.jupiter.api.Test;

class RosDrawingTest {
    private static final int SIZE = 400;
    private static final long SECOND = 1_000_000_000;
    private static final MapView VIEW = new MapView(0.1, 0, 0, MapView.Y_UP, SIZE, SIZE);

    private final RosDrawing drawing = new RosDrawing();

    @Test
    void beforeTheFirstReportTheMapHasOnlyWords() {
        int[] words = painted();
        drawing.show(Scenes.of(Scenes.circle(1000, SECOND)), Pose.START);
        assertThat(differing(words, painted())).isPositive();
    }

    @Test
    void theSeenAreaEndsAtTheEchoesAndABeamWithoutAnEchoIsNotFree() {
        drawing.show(Scenes.of(Scenes.circle(1000, SECOND)), Pose.START);
        int[] all = painted();
        double[] none = new double[360];
        Arrays.fill(none, Double.NaN);
        drawing.show(Scenes.of(ScanEchoes.of(none, none, SECOND)), Pose.START);
        int[] nothing = painted();

        assertThat(differs(all, nothing, 800, 300)).isTrue();
        assertThat(differs(all, nothing, 1200, 300)).isFalse();
    }

    @Test
    void echoesAreKeptWhereTheRobotWasAndAScanIsAddedOnce() {
        drawing.show(Scenes.of(null, List.of(), RosScene.Battery.UNKNOWN, List.of()), Pose.START);
        int[] before = painted();
        ScanEchoes wall = ScanEchoes.of(new double[] {1000}, new double[] {0}, SECOND);
        drawing.record(new Pose(0, 0, 90), Optional.of(wall));
        drawing.record(new Pose(0, 0, 0), Optional.of(wall));

        assertThat(differs(before, painted(), 0, 1000)).isTrue();
        assertThat(differs(before, painted(), 1000, 0)).isFalse();
        assertThat(drawing.extent().contains(0, 1000)).isTrue();
        drawing.clear();
        assertThat(differs(before, painted(), 0, 1000)).isFalse();
    }

    @Test
    void theMapFollowsTheRobot() {
        drawing.show(Scenes.of(Scenes.circle(1000, SECOND)), new Pose(2000, 500, 0));
        assertThat(drawing.pose().xMm()).isCloseTo(2000, within(1.0));
    }

    @Test
    void aContactIsMarkedAroundTheHull() {
        drawing.show(Scenes.of(null, List.of(), RosScene.Battery.UNKNOWN, List.of()), Pose.START);
        int[] free = painted();
        drawing.show(
                Scenes.of(
                        null, List.of(new RosScene.Contact(Hazard.BUMP, "left")), RosScene.Battery.UNKNOWN, List.of()),
                Pose.START);
        int[] touching = painted();
        int alarm = DrawingColors.current().alarm().getRGB();
        assertThat(IntStream.of(free).filter(pixel -> pixel == alarm)).isEmpty();
        assertThat(IntStream.of(touching).filter(pixel -> pixel == alarm)).isNotEmpty();
    }

    private int[] painted() {
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        drawing.paint(pen, VIEW);
        pen.dispose();
        return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
    }

    private static boolean differs(int[] one, int[] other, double xMm, double yMm) {
        var at = VIEW.pixel(xMm, yMm);
        int pixel = (int) at.getY() * SIZE + (int) at.getX();
        return IntStream.of(0, 1, -1, SIZE, -SIZE).anyMatch(near -> one[pixel + near] != other[pixel + near]);
    }

    private static long differing(int[] one, int[] other) {
        return IntStream.range(0, one.length)
                .filter(pixel -> one[pixel] != other[pixel])
                .count();
    }
}

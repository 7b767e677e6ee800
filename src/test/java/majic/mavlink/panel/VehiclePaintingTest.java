package majic.mavlink.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.inlab.LaidOutPanel;
import majic.mavlink.panel.VehicleScene.Attitude;
import majic.mavlink.panel.VehicleScene.Echo;
import majic.mavlink.panel.VehicleScene.Echoes;
import majic.mavlink.panel.VehicleScene.Message;
import majic.mavlink.panel.VehicleScene.Severity;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class VehiclePaintingTest {
    private static final int SIZE = 200;
    private static final MapView VIEW = new MapView(0.05, 0, 0, MapView.Y_UP, SIZE, SIZE);

    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        LaidOutPanel.lookAsInTheProgram();
    }

    private static int[] onEventThread(Callable<int[]> painting) throws Exception {
        int[][] pixels = new int[1][];
        SwingUtilities.invokeAndWait(() -> {
            try {
                pixels[0] = painting.call();
            } catch (Exception e) {
                throw new AssertionError(e);
            }
        });
        return pixels[0];
    }

    private static int[] compass(Attitude attitude, boolean current) throws Exception {
        return onEventThread(() -> {
            CompassRing ring = new CompassRing();
            ring.show(Optional.ofNullable(attitude), current);
            return painted(ring);
        });
    }

    private static int[] painted(Container component) {
        component.setSize(SIZE, SIZE);
        layOut(component);
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        component.paint(pen);
        pen.dispose();
        return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
    }

    private static void layOut(Container container) {
        container.doLayout();
        Arrays.stream(container.getComponents())
                .filter(Container.class::isInstance)
                .forEach(child -> layOut((Container) child));
    }

    private static long alarms(int[] pixels) {
        int alarm = DrawingColors.current().alarm().getRGB();
        return IntStream.of(pixels).filter(pixel -> pixel == alarm).count();
    }

    @Test
    void theCompassTurnsAndTheHorizonTilts() throws Exception {
        int[] level = compass(new Attitude(0, 0, 0, true), true);
        assertThat(compass(new Attitude(0, 0, 90, true), true)).isNotEqualTo(level);
        assertThat(compass(new Attitude(20, 0, 0, true), true)).isNotEqualTo(level);
        assertThat(compass(new Attitude(0, 10, 0, true), true)).isNotEqualTo(level);
    }

    @Test
    void anOldAttitudeLooksAsOneOfALostVehicle() throws Exception {
        int[] lost = compass(new Attitude(5, 5, 40, true), false);
        assertThat(compass(new Attitude(5, 5, 40, false), true)).isEqualTo(lost);
        assertThat(compass(new Attitude(5, 5, 40, true), true)).isNotEqualTo(lost);
    }

    @Test
    void withoutAnAttitudeThereIsNeitherRoseNorGround() throws Exception {
        assertThat(compass(null, true)).isNotEqualTo(compass(new Attitude(0, 0, 0, true), true));
    }

    private static int[] messages(Severity kind, boolean current) throws Exception {
        return onEventThread(() -> {
            AutopilotMessages messages = new AutopilotMessages();
            messages.show(List.of(new Message(kind, "Arm: Accels inconsistent", 3)), current);
            // Rows are laid out in a window only.
            JFrame frame = new JFrame("messages");
            frame.add(messages);
            frame.pack();
            try {
                return painted(messages);
            } finally {
                frame.dispose();
            }
        });
    }

    @Test
    void errorsAloneAreInTheAlarmColour() throws Exception {
        assertThat(alarms(messages(Severity.ERROR, true))).isPositive();
        assertThat(alarms(messages(Severity.WARNING, true))).isZero();
        assertThat(alarms(messages(Severity.INFO, true))).isZero();
        assertThat(alarms(messages(Severity.ERROR, false))).isZero();
    }

    @Test
    void echoesAreKeptWhereTheVehicleWasAndAreAddedOnce() {
        VehicleDrawing drawing = new VehicleDrawing();
        drawing.show(new VehicleDrawing.PlacedVehicle(Pose.START, 350, true));
        Echoes wall = new Echoes(List.of(new Echo(1000, 0)), 1);
        drawing.record(new Pose(0, 0, 90), Optional.of(wall));
        int[] once = drawn(drawing);
        drawing.record(Pose.START, Optional.of(wall));

        assertThat(drawing.extent().contains(0, 1000)).isTrue();
        assertThat(drawn(drawing)).isEqualTo(once);
        drawing.clear();
        assertThat(drawn(drawing)).isNotEqualTo(once);
    }

    private static int[] drawn(VehicleDrawing drawing) {
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        drawing.paint(pen, VIEW);
        pen.dispose();
        return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
    }
}

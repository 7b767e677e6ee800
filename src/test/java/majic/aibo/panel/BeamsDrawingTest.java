package majic.aibo.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import majic.aibo.body.Calibration;
import majic.aibo.body.DogState;
import majic.environment.Settings;
import majic.panel.DrawingColors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rings reach 70 pixels from where the head turns, the nose 35; the room is 90 wide to each side. */
class BeamsDrawingTest {
    private static final double ROOM_PX = 90;
    private static final Rectangle2D ROOM = new Rectangle2D.Double(-ROOM_PX, -70, 2 * ROOM_PX, 140);
    private static final Rectangle2D DOG = new Rectangle2D.Double(-35, -45, 70, 115);

    private final BeamsDrawing beams = new BeamsDrawing(
            new DogState(new Calibration(Settings.inMemory(), "host")), DrawingColors.current(), 70, 35);

    @ParameterizedTest
    @ValueSource(ints = {-90, -60, -30, 0, 30, 60, 90})
    void theDistanceIsBesideTheDogAndTheHit(int panDeg) {
        for (double radius = 35; radius <= 70; radius += 5) {
            double angle = Math.toRadians(panDeg);
            Point2D hit = new Point2D.Double(-radius * Math.sin(angle), -radius * Math.cos(angle));
            Rectangle2D label = beams.labelAt(hit, 52, 15, ROOM_PX);
            assertThat(ROOM.contains(label)).as("in the room").isTrue();
            assertThat(DOG.intersects(label)).as("over the dog").isFalse();
        }
    }
}

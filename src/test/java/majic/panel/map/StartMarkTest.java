package majic.panel.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Rectangle2D;
import java.util.Optional;
import majic.bot.Pose;
import org.junit.jupiter.api.Test;

/** A map of 200 × 200 pixels, one for each 10 mm, with the start of the trail in its middle. */
class StartMarkTest {
    private static final MapView VIEW = new MapView(0.1, 0, 0, MapView.Y_UP, 200, 200);
    private static final double RADIUS_PX = 25;

    @Test
    void theLabelIsBelowTheRing() {
        assertThat(label(new Pose(800, 0, 0))).contains(new Rectangle2D.Double(85, 105, 30, 12));
    }

    @Test
    void theLabelIsBelowARobotThatCoversTheStart() {
        assertThat(label(Pose.START)).contains(new Rectangle2D.Double(85, 126, 30, 12));
    }

    @Test
    void theLabelIsNotMovedFarFromTheStart() {
        assertThat(label(new Pose(0, -300, 0))).isEmpty();
    }

    @Test
    void theLabelIsNotCutByTheEdge() {
        MapView moved = VIEW.moved(-95, 0);
        assertThat(new StartMark(moved, new Pose(1500, 0, 0), RADIUS_PX).label(30, 12))
                .isEmpty();
    }

    private static Optional<Rectangle2D> label(Pose robot) {
        return new StartMark(VIEW, robot, RADIUS_PX).label(30, 12);
    }
}

package majic.panel.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MapViewTest {
    private static final MapView VIEW = new MapView(0.1, 500, -200, MapView.Y_UP, 400, 300);

    @ParameterizedTest
    @ValueSource(doubles = {90, 0, -135, 17.5})
    void aPlaceIsFoundUnderItsPixel(double upDeg) {
        MapView view = new MapView(0.1, 500, -200, upDeg, 400, 300);
        Point2D pixel = view.pixel(1234, 567);
        assertAt(view.place(pixel.getX(), pixel.getY()), 1234, 567);
    }

    @Test
    void yPointsUpUnlessTheFloorIsTurned() {
        assertAt(VIEW.pixel(500, 800), 200, 50);
        assertAt(new MapView(0.1, 500, -200, 0, 400, 300).pixel(1500, -200), 200, 50);
    }

    @Test
    void zoomingKeepsThePlaceUnderTheMouse() {
        Point2D before = VIEW.place(30, 40);
        assertAt(VIEW.zoomed(3, 30, 40).place(30, 40), before.getX(), before.getY());
    }

    @Test
    void draggingTakesThePlaceAlong() {
        Point2D before = VIEW.place(100, 100);
        assertAt(VIEW.moved(25, -10).place(125, 90), before.getX(), before.getY());
    }

    @Test
    void theScaleStaysWithinItsLimits() {
        assertThat(VIEW.zoomed(1e6, 0, 0).pxPerMm()).isEqualTo(2);
        assertThat(VIEW.zoomed(1e-6, 0, 0).pxPerMm()).isEqualTo(0.002);
    }

    @Test
    void everythingIsSeenWhenItFits() {
        MapView view = MapView.fitting(new Rectangle2D.Double(-1000, -500, 4000, 1000), 400, 300);
        assertAt(view.pixel(-1000, 0), 0, 150);
        assertAt(view.pixel(3000, 0), 400, 150);
    }

    private static void assertAt(Point2D point, double x, double y) {
        assertThat(point.getX()).isCloseTo(x, within(1e-6));
        assertThat(point.getY()).isCloseTo(y, within(1e-6));
    }
}

package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import java.util.List;
import majic.bot.LabAccess.Furnishing;
import majic.bot.LabAccess.Wall;
import majic.panel.Lengths;
import org.junit.jupiter.api.Test;

class MapViewTest {
    private static final Extent FLOOR = new Extent(0, 0, 4000, 2000);

    @Test
    void aFittingViewShowsTheWholeFloorWithYUpwards() {
        MapView view = MapView.fitting(FLOOR, 400, 400);
        assertThat(view.pixelsPerMm()).isEqualTo(0.1);
        assertThat(view.x(4000)).isEqualTo(400);
        assertThat(view.y(0)).isEqualTo(300);
        assertThat(view.y(2000)).isEqualTo(100);
    }

    @Test
    void zoomingKeepsThePlaceUnderTheMouse() {
        MapView view = MapView.fitting(FLOOR, 400, 400);
        Point2D mouse = new Point2D.Double(30, 170);
        MapScene.Point before = view.place(mouse);
        MapScene.Point after = view.zoomed(1.7, mouse).place(mouse);
        assertThat(after.xMm()).isCloseTo(before.xMm(), within(1e-6));
        assertThat(after.yMm()).isCloseTo(before.yMm(), within(1e-6));
    }

    @Test
    void zoomingHasItsLimits() {
        MapView view = MapView.fitting(FLOOR, 400, 400);
        Point2D mouse = new Point2D.Double();
        assertThat(view.zoomed(1e9, mouse).pixelsPerMm()).isEqualTo(4);
        assertThat(view.zoomed(1e-9, mouse).pixelsPerMm()).isEqualTo(0.002);
    }

    @Test
    void theExtentOfARoomIsTheRoomAndAMargin() {
        MapScene scene =
                new MapScene(List.of(new Wall(0, 0, 4000, 3000)), Furnishing.NONE, List.of(), List.of(), false);
        assertThat(Extent.of(scene)).isEqualTo(new Extent(-200, -200, 4200, 3200));
    }

    @Test
    void lengthsOfScaleBarsAreRound() {
        assertThat(Lengths.round(730)).isEqualTo(500);
        assertThat(Lengths.round(1999)).isEqualTo(1000);
        assertThat(Lengths.text(2000)).isEqualTo("2 m");
        assertThat(Lengths.text(500)).isEqualTo("50 cm");
        assertThat(Lengths.text(20)).isEqualTo("20 mm");
    }
}

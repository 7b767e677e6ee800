package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DashboardTest {
    private final JPanel view = new JPanel();
    private final JPanel picture = new JPanel();
    private final JPanel controls = new JPanel();
    private final JPanel map = new JPanel();
    private final StatusLightsPanel lights = lights();
    private final ReadingsPanel<String> readings = new ReadingsPanel<>("8888 mm");
    private final Banner banner = new Banner();
    private final JPanel parent = new JPanel();

    /** Texts have other sizes in other looks. */
    @BeforeAll
    static void useTheLookOfTheWindow() {
        FlatLightLaf.setup();
    }

    @BeforeEach
    void fill() {
        picture.setPreferredSize(new Dimension(208, 160));
        controls.setPreferredSize(new Dimension(150, 120));
        controls.setMinimumSize(new Dimension(150, 120));
        for (int row = 0; row < 8; row++) {
            readings.with("reading" + row, value -> value);
        }
    }

    private static StatusLightsPanel lights() {
        List<StatusLight> lights = IntStream.range(0, 6)
                .mapToObj(index -> new StatusLight("light" + index, "tip"))
                .toList();
        return new StatusLightsPanel("something is on", lights);
    }

    /** Creates a view with a picture and controls beside it. */
    private void camera() {
        arrange(new Dashboard(view, 0.38, List.of(SidePane.shaped(picture), SidePane.of(controls)), readings));
        List.of(view, picture, controls, readings).forEach(parent::add);
    }

    /** Creates a square view with lights and a map beside it. */
    private void square() {
        arrange(new Dashboard(view, 1, List.of(SidePane.of(lights), SidePane.stretched(map)), readings).under(banner));
        List.of(view, lights, map, readings, banner).forEach(parent::add);
    }

    /** Creates a view of any shape with controls and lights beside it. */
    private void wide() {
        arrange(new Dashboard(view, 0, List.of(SidePane.of(controls), SidePane.of(lights)), readings));
        List.of(view, controls, lights, readings).forEach(parent::add);
    }

    private void arrange(Dashboard layout) {
        parent.removeAll();
        parent.setLayout(layout);
    }

    @ParameterizedTest
    @CsvSource({"900, 560", "515, 270", "2000, 1200", "700, 450", "420, 900", "340, 250", "1400, 300", "500, 500"})
    void nothingLiesOverAnotherOrOutside(int width, int height) {
        for (Runnable kind : List.<Runnable>of(this::camera, this::square, this::wide)) {
            kind.run();
            layOut(width, height);
            assertThat(boxes()).allMatch(new Rectangle(width, height)::contains);
            for (Rectangle one : boxes()) {
                assertThat(boxes()).filteredOn(one::intersects).hasSize(1);
            }
        }
    }

    private List<Rectangle> boxes() {
        return Arrays.stream(parent.getComponents())
                .filter(Component::isVisible)
                .map(Component::getBounds)
                .toList();
    }

    @Test
    void aPictureKeepsItsShapeWhereThereIsRoom() {
        camera();
        layOut(900, 560);

        assertThat(picture.getWidth() / (double) picture.getHeight()).isBetween(1.29, 1.31);
        assertThat(readings.isVisible()).isTrue();
    }

    @Test
    void inLittleRoomTheReadingsGoFirstAndTheControlsStay() {
        camera();
        layOut(515, 270);

        assertThat(readings.isVisible()).isFalse();
        assertThat(controls.getHeight()).isEqualTo(120);
        assertThat(picture.getHeight()).isGreaterThan(60);
    }

    @Test
    void importantReadingsAreShownEvenIfTheViewGetsMuchSmaller() {
        ReadingsPanel<String> distances = new ReadingsPanel<>("-88888.8 mm");
        List.of("front", "back", "left", "right", "packetRate", "firmware")
                .forEach(name -> distances.with(name, value -> value));
        controls.setPreferredSize(new Dimension(150, 80));
        arrange(new Dashboard(view, 0, List.of(SidePane.of(controls), SidePane.of(lights)), distances));
        List.of(view, controls, lights, distances).forEach(parent::add);
        layOut(380, 280);
        assertThat(distances.isVisible()).isFalse();

        distances.paired(4, "8888 mm");
        layOut(380, 280);
        assertThat(distances.isVisible()).isTrue();
        assertThat(view.getWidth()).isBetween(110, 160);
    }

    @Test
    void forImportantReadingsTheLightsStandTwoInARow() {
        ReadingsPanel<String> distances = new ReadingsPanel<>("8888 mm");
        List.of("front", "back", "left", "right").forEach(name -> distances.with(name, value -> value));
        distances.paired(4, "8888 mm");
        arrange(new Dashboard(view, 0, List.of(SidePane.of(controls), SidePane.of(lights)), distances));
        List.of(view, controls, lights, distances).forEach(parent::add);

        layOut(410, 275);

        assertThat(distances.isVisible()).isTrue();
        assertThat(lights.getHeight()).isLessThan(lights.getPreferredSize().height);
        assertThat(view.getWidth()).isGreaterThan(95);
    }

    @Test
    void inATallSpaceTheViewIsOnTop() {
        camera();
        layOut(500, 900);

        assertThat(view.getWidth()).isGreaterThan(450);
        assertThat(picture.getY()).isGreaterThan(view.getHeight());
        assertThat(controls.getX()).isGreaterThan(picture.getX() + picture.getWidth());
    }

    @Test
    void itsLeastSizeHoldsTheControls() {
        camera();
        Dimension least = parent.getMinimumSize();
        layOut(least.width, least.height);

        assertThat(controls.getSize()).isEqualTo(new Dimension(150, 120));
        assertThat(view.getWidth()).isGreaterThan(100);
    }

    @Test
    void whatASquareViewLeavesOverGoesToTheMap() {
        square();
        layOut(1200, 500);

        assertThat(view.getWidth()).isBetween(480, 500);
        assertThat(map.getWidth()).isGreaterThan(600);
        assertThat(readings.isVisible()).isTrue();
    }

    @Test
    void aMapThatWouldBeTooSmallGoes() {
        square();
        layOut(340, 130);

        assertThat(map.isVisible()).isFalse();
        assertThat(lights.getHeight()).isEqualTo(lights.heightIn(lights.getWidth()));
    }

    @Test
    void aViewIsLargeEnoughToBeReadOrGone() {
        for (Runnable kind : List.<Runnable>of(this::camera, this::square, this::wide)) {
            kind.run();
            for (int width = 150; width <= 600; width += 25) {
                for (int height = 100; height <= 500; height += 25) {
                    layOut(width, height);
                    assertThat(!view.isVisible() || Math.min(view.getWidth(), view.getHeight()) >= 96)
                            .as(width + " × " + height)
                            .isTrue();
                }
            }
            layOut(900, 560);
            assertThat(view.isVisible()).isTrue();
        }
    }

    @Test
    void theBannerTakesSpaceOnlyWhileItShowsAMessage() {
        square();
        layOut(900, 560);
        int quiet = view.getY();

        banner.show("It does not answer. Switch it off.", true);
        layOut(900, 560);

        assertThat(view.getY()).isGreaterThan(quiet + 10);
        assertThat(banner.getWidth()).isGreaterThan(850);
    }

    @Test
    void aViewOfAnyShapeGetsWhatTheColumnDoesNotNeed() {
        wide();
        layOut(1400, 300);

        assertThat(view.getWidth()).isGreaterThan(1000);
    }

    private void layOut(int width, int height) {
        parent.setSize(width, height);
        parent.doLayout();
    }
}

package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.List;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CockpitTest {
    private final JPanel view = new JPanel();
    private final JPanel picture = new JPanel();
    private final JPanel controls = new JPanel();
    private final NumbersPanel numbers = new NumbersPanel();
    private final JPanel parent = new JPanel();

    @BeforeEach
    void fill() {
        picture.setPreferredSize(new Dimension(208, 160));
        controls.setPreferredSize(new Dimension(150, 120));
        controls.setMinimumSize(new Dimension(150, 120));
        for (int row = 0; row < 8; row++) {
            numbers.row("reading" + row, "8888 mm");
        }
        List.of(view, picture, controls, numbers).forEach(parent::add);
        parent.setLayout(new Cockpit(view, picture, controls, numbers));
    }

    @ParameterizedTest
    @CsvSource({"900, 560", "515, 270", "2000, 1200", "700, 450", "420, 900", "330, 250", "1400, 300"})
    void nothingLiesOverAnotherOrOutside(int width, int height) {
        layOut(width, height);
        List<Component> shown = List.of(view, picture, controls, numbers);
        for (Component one : shown) {
            assertThat(new Rectangle(width, height).contains(one.getBounds())
                            || one.getBounds().isEmpty())
                    .isTrue();
            shown.stream()
                    .filter(other -> other != one)
                    .forEach(other -> assertThat(one.getBounds().intersects(other.getBounds()))
                            .isFalse());
        }
    }

    @Test
    void thePictureKeepsItsShapeWhereThereIsRoom() {
        layOut(900, 560);

        assertThat(picture.getWidth() / (double) picture.getHeight()).isBetween(1.29, 1.31);
    }

    @Test
    void inLittleRoomTheReadingsGoFirstAndTheControlsStay() {
        layOut(515, 270);

        assertThat(numbers.isVisible()).isFalse();
        assertThat(controls.getHeight()).isEqualTo(120);
        assertThat(picture.getHeight()).isGreaterThan(60);
    }

    @Test
    void inATallRoomTheViewStandsOnTop() {
        layOut(500, 900);

        assertThat(view.getWidth()).isGreaterThan(450);
        assertThat(picture.getY()).isGreaterThan(view.getHeight());
        assertThat(controls.getX()).isGreaterThan(picture.getX() + picture.getWidth());
    }

    @Test
    void itsLeastSizeHoldsTheControls() {
        Dimension least = parent.getMinimumSize();
        layOut(least.width, least.height);

        assertThat(controls.getSize()).isEqualTo(new Dimension(150, 120));
        assertThat(view.getWidth()).isGreaterThan(100);
    }

    private void layOut(int width, int height) {
        parent.setSize(width, height);
        parent.doLayout();
    }
}

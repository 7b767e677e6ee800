package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

class PictureViewTest {
    private static final Color WALL = new Color(0xC04020);

    private final PictureView view = new PictureView(208, 160);

    @Test
    void aPictureFillsTheRoomAndKeepsItsShape() {
        view.show(picture(100, 100), "5.0 frames/s");
        BufferedImage painted = painted(300, 200);

        assertThat(painted.getRGB(60, 20)).isEqualTo(WALL.getRGB());
        assertThat(painted.getRGB(240, 20)).isEqualTo(WALL.getRGB());
        assertThat(painted.getRGB(40, 20)).isNotEqualTo(WALL.getRGB());
        assertThat(painted.getRGB(260, 20)).isNotEqualTo(WALL.getRGB());
    }

    @Test
    void aTextIsShownOverTheFadedLastPicture() {
        view.show(picture(208, 160), "5.0 frames/s");
        view.miss("not connected");
        BufferedImage painted = painted(208, 160);

        assertThat(shownText()).isEqualTo("camera, not connected");
        assertThat(painted.getRGB(20, 20)).isNotEqualTo(WALL.getRGB());
    }

    @Test
    void theReasonOfARobotIsShownInTheLanguageOfTheWindow() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMAN);
            view.miss("desk2/1 has sent no picture");

            assertThat(shownText()).isEqualTo("Kamera, desk2/1 hat kein Bild gesendet");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void theNextPictureTakesTheWordsAway() {
        view.miss("not connected");
        view.show(picture(208, 160), "5.0 frames/s");

        assertThat(shownText()).isEqualTo("camera, 5.0 frames/s");
        assertThat(painted(208, 160).getRGB(20, 20)).isEqualTo(WALL.getRGB());
    }

    @Test
    void withoutAConnectionTheLastPictureIsNotShownAsCurrent() {
        view.show(picture(208, 160), "5.0 frames/s");
        view.setCurrent(false);

        assertThat(shownText()).isEqualTo("camera, not connected");
        assertThat(painted(208, 160).getRGB(20, 20)).isNotEqualTo(WALL.getRGB());

        view.setCurrent(true);

        assertThat(shownText()).isEqualTo("camera, 5.0 frames/s");
        assertThat(painted(208, 160).getRGB(20, 20)).isEqualTo(WALL.getRGB());
    }

    @Test
    void longWordsAreBrokenIntoLinesInsideTheFrame() {
        view.miss("the picture is damaged and says so at length");
        BufferedImage painted = painted(120, 160);
        for (int y = 2; y < 158; y++) {
            assertThat(painted.getRGB(117, y)).isEqualTo(painted.getRGB(2, y));
        }
        assertThat(shownText()).endsWith("at length");
    }

    @Test
    void aCopyInAWindowShowsTheSamePictures() {
        PictureView copy = view.copy(640, 480);
        copy.addNotify();
        view.show(picture(208, 160), "5.0 frames/s");

        assertThat(copy.image()).isPresent().isEqualTo(view.image());
        assertThat(copy.getAccessibleContext().getAccessibleName()).isEqualTo("camera, 5.0 frames/s");
        copy.removeNotify();
    }

    @Test
    void aClickAsksTheSurroundingWindowForALargerView() {
        List<PictureView> enlarged = new ArrayList<>();
        class Viewer extends JPanel implements PictureViewer {
            private static final long serialVersionUID = 1L;

            @Override
            public void enlarge(PictureView clicked) {
                enlarged.add(clicked);
            }
        }
        JPanel inner = new JPanel();
        inner.add(view);
        new Viewer().add(inner);
        view.dispatchEvent(new MouseEvent(view, MouseEvent.MOUSE_CLICKED, 0, 0, 5, 5, 1, false, MouseEvent.BUTTON1));

        assertThat(enlarged).containsExactly(view);
    }

    /** Returns what a screen reader reads: the caption, or why there is no picture. */
    private String shownText() {
        return view.getAccessibleContext().getAccessibleName();
    }

    private static BufferedImage picture(int width, int height) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int pixel = 0; pixel < width * height; pixel++) {
            picture.setRGB(pixel % width, pixel / width, WALL.getRGB());
        }
        return picture;
    }

    private BufferedImage painted(int width, int height) {
        view.setSize(width, height);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        view.paint(image.getGraphics());
        return image;
    }
}

package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import majic.panel.Horizon.Tilt;
import org.junit.jupiter.api.Test;

/** A disc of 100 pixels, whose middle is the robot: 25 pixels are 30 degrees. */
class HorizonTest {
    private static final int SIZE = 101;
    private static final int MIDDLE = 50;
    private static final int ASIDE = 34;

    private final Horizon horizon = new Horizon(SIZE);

    @Test
    void levelGroundFillsTheLowerHalf() {
        BufferedImage level = painted(new Tilt(0, 0));
        int sky = level.getRGB(MIDDLE, 20);
        int ground = level.getRGB(MIDDLE, 85);

        assertThat(ground).isNotEqualTo(sky);
        assertThat(level.getRGB(MIDDLE - ASIDE, MIDDLE + 8)).isEqualTo(ground);
        assertThat(level.getRGB(MIDDLE + ASIDE, MIDDLE - 8)).isEqualTo(sky);
    }

    @Test
    void aRaisedNoseSeesMoreSky() {
        int sky = painted(new Tilt(0, 0)).getRGB(MIDDLE, 20);

        assertThat(painted(new Tilt(30, 0)).getRGB(MIDDLE - ASIDE, MIDDLE + 15)).isEqualTo(sky);
        assertThat(painted(new Tilt(-30, 0)).getRGB(MIDDLE - ASIDE, MIDDLE - 8)).isNotEqualTo(sky);
    }

    @Test
    void onItsRightSideTheGroundComesUpOnTheRight() {
        BufferedImage level = painted(new Tilt(0, 0));
        int sky = level.getRGB(MIDDLE, 20);
        int ground = level.getRGB(MIDDLE, 85);
        BufferedImage rolled = painted(new Tilt(0, 40));

        assertThat(rolled.getRGB(MIDDLE + ASIDE, MIDDLE - 10)).isEqualTo(ground);
        assertThat(rolled.getRGB(MIDDLE - ASIDE, MIDDLE + 10)).isEqualTo(sky);
    }

    @Test
    void withoutAReadingThereIsNoGround() {
        horizon.show(new Tilt(12.6, -3));
        assertThat(horizon.getToolTipText()).endsWith("13° nose up, −3° to the right");
        BufferedImage unknown = painted(null);

        assertThat(horizon.getToolTipText()).endsWith("no reading");
        assertThat(unknown.getRGB(MIDDLE, 85)).isEqualTo(unknown.getRGB(MIDDLE, 20));
    }

    @Test
    void smallChangesAddUpUntilTheyAreSeen() {
        horizon.show(new Tilt(12.4, 0));
        horizon.show(new Tilt(13.2, 0));
        assertThat(horizon.getToolTipText()).contains("12°");

        horizon.show(new Tilt(13.5, 0));
        assertThat(horizon.getToolTipText()).contains("14°");
    }

    private BufferedImage painted(Tilt tilt) {
        horizon.show(tilt);
        horizon.setSize(SIZE, SIZE);
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        horizon.paint(image.getGraphics());
        return image;
    }
}

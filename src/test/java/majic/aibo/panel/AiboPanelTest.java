package majic.aibo.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.Optional;
import majic.aibo.body.Calibration;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.urbi.UrbiValue;
import majic.environment.Settings;
import org.junit.jupiter.api.Test;

class AiboPanelTest {
    private final DogState dog = new DogState(new Calibration(Settings.inMemory(), "host"));

    @Test
    void theDrawingShowsTheDirectionOfTheHeadAndTheObstaclesThere() {
        BufferedImage ahead = drawn();
        dog.senses().put(Sensor.HEAD_PAN, new UrbiValue.Num(40), 1);
        dog.senses().put(Sensor.NEAR, new UrbiValue.Num(30), 1);

        BufferedImage aside = drawn();

        assertThat(dog.infraRed().headMm()).isEqualTo(Optional.of(300.0));
        assertThat(pixels(aside)).isNotEqualTo(pixels(ahead));
    }

    @Test
    void aDogThatIsNotConnectedIsDrawnPale() {
        DogDrawing drawing = new DogDrawing(dog);
        drawing.setEnabled(false);

        assertThat(pixels(drawn(drawing))).isNotEqualTo(pixels(drawn()));
    }

    private BufferedImage drawn() {
        return drawn(new DogDrawing(dog));
    }

    private static BufferedImage drawn(DogDrawing drawing) {
        drawing.setSize(400, 300);
        BufferedImage image = new BufferedImage(400, 300, BufferedImage.TYPE_INT_RGB);
        drawing.paint(image.getGraphics());
        return image;
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, 400, 300, null, 0, 400);
    }
}

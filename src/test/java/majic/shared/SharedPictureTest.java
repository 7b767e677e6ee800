package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import majic.bot.BotException;
import org.junit.jupiter.api.Test;

/** Tests pictures of a shared robot: they are taken as those of a robot of this desk. */
class SharedPictureTest {
    @Test
    void isTakenByTheCameraOfTheRobot() throws IOException {
        try (SharedLabRobot aibo = new SharedLabRobot("aibo")) {
            assertThat(aibo.bot().hasCamera()).isFalse();
            aibo.bot().connect();

            byte[] jpeg = aibo.bot().takePicture();

            assertThat(aibo.bot().hasCamera()).isTrue();
            assertThat(ImageIO.read(new ByteArrayInputStream(jpeg)).getWidth()).isPositive();
        }
    }

    @Test
    void isRefusedByARobotWithoutCamera() {
        try (SharedLabRobot pioneer = new SharedLabRobot("pioneer")) {
            pioneer.bot().connect();

            assertThat(pioneer.bot().hasCamera()).isFalse();
            assertThatThrownBy(() -> pioneer.bot().takePicture())
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("has no camera");
        }
    }
}

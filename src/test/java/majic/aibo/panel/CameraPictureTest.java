package majic.aibo.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import majic.aibo.urbi.UrbiValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CameraPictureTest {
    @Test
    void aJpegIsDecoded() throws IOException {
        BufferedImage picture = CameraPicture.of(binary("jpeg 16 8 8", jpeg()));

        assertThat(picture.getWidth()).isEqualTo(16);
        assertThat(picture.getHeight()).isEqualTo(8);
        assertThat(new Color(picture.getRGB(3, 3)).getRed()).isGreaterThan(180);
    }

    @ParameterizedTest
    @CsvSource({"255, 128, 128, 255, 255, 255", "76, 85, 255, 254, 0, 0", "29, 255, 107, 0, 0, 254"})
    void lumaAndChromaBecomeColours(int luma, int blue, int red, int r, int g, int b) {
        byte[] pixel = {(byte) luma, (byte) blue, (byte) red};

        Color color = new Color(CameraPicture.of(binary("YCbCr 1 1", pixel)).getRGB(0, 0));

        assertThat(List.of(color.getRed(), color.getGreen(), color.getBlue())).isEqualTo(List.of(r, g, b));
    }

    @ParameterizedTest
    @CsvSource({"20", "100", "150"})
    void aJpegCutShortIsDamaged(int left) throws IOException {
        byte[] cut = Arrays.copyOf(jpeg(), left);

        assertThatThrownBy(() -> CameraPicture.of(binary("jpeg 16 8", cut))).hasMessageContaining("damaged");
    }

    @Test
    void aPictureWithoutAllItsBytesIsDamaged() {
        assertThatThrownBy(() -> CameraPicture.of(binary("YCbCr 2 2", new byte[11])))
                .hasMessage("the picture is damaged: 11 bytes for 12");
        assertThatThrownBy(() -> CameraPicture.of(binary("YCbCr 99999 99999", new byte[12])))
                .hasMessageContaining("99999 × 99999");
        assertThatThrownBy(() -> CameraPicture.of(binary("YCbCr", new byte[12])))
                .hasMessageContaining("damaged");
    }

    @Test
    void dataWithoutAPictureAreRefused() {
        assertThatThrownBy(() -> CameraPicture.of(new UrbiValue.Num(0))).hasMessageContaining("no picture");
        assertThatThrownBy(() -> CameraPicture.of(binary("raw 2 16000 16 1", new byte[4])))
                .hasMessageContaining("raw");
    }

    private static UrbiValue binary(String words, byte[] bytes) {
        return new UrbiValue.Binary(List.of(words.split(" ")), bytes);
    }

    private static byte[] jpeg() throws IOException {
        BufferedImage red = new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB);
        for (int pixel = 0; pixel < 16 * 8; pixel++) {
            red.setRGB(pixel % 16, pixel / 16, Color.RED.getRGB());
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(red, "jpeg", out);
        return out.toByteArray();
    }
}

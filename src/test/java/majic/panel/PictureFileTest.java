package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PictureFileTest {
    /** Width and height of a PNG file are at fixed places (PNG specification, 11.2.2). */
    private static final int PNG_WIDTH = 16;

    private static byte[] file(String format) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB), format, file);
        return file.toByteArray();
    }

    @ParameterizedTest
    @ValueSource(strings = {"jpeg", "png"})
    void aPictureIsDecodedAndAHalfOneIsDamaged(String format) throws IOException {
        byte[] file = file(format);
        assertThat(PictureFile.decode(file).getWidth()).isEqualTo(16);
        assertThatThrownBy(() -> PictureFile.decode(Arrays.copyOf(file, file.length * 2 / 3)))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("the picture is damaged");
    }

    @Test
    void aPictureHasTheFormatThatWindowsDrawWithoutConversion() throws IOException {
        assertThat(PictureFile.decode(file("jpeg")).getType()).isEqualTo(BufferedImage.TYPE_INT_RGB);
        assertThat(PictureFile.decode(file("png")).getType()).isEqualTo(BufferedImage.TYPE_INT_RGB);
    }

    @Test
    void aPictureKeepsItsColoursAndItsTransparency() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 0xFFC04020);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(image, "png", file);
        BufferedImage decoded = PictureFile.decode(file.toByteArray());

        assertThat(decoded.getRGB(0, 0)).isEqualTo(0xFFC04020);
        assertThat(decoded.getRGB(1, 0) >>> 24).isZero();
    }

    @Test
    void somethingElseIsRefused() {
        assertThatThrownBy(() -> PictureFile.decode("<html>".getBytes()))
                .isInstanceOf(IOException.class)
                .hasMessage("the picture is neither JPEG nor PNG");
    }

    @Test
    void aPictureThatClaimsToBeHugeTakesNoMemory() throws IOException {
        byte[] png = file("png");
        ByteBuffer.wrap(png).putInt(PNG_WIDTH, 60_000).putInt(PNG_WIDTH + 4, 60_000);
        assertThatThrownBy(() -> PictureFile.decode(png)).hasMessageContaining("60000 × 60000");
    }
}

package majic.ros.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;
import majic.gui.WindowWait;
import majic.panel.PictureFile;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class RosCameraTest {
    private RosCamera camera;

    @BeforeEach
    void make() throws Exception {
        SwingUtilities.invokeAndWait(() -> camera = new RosCamera(TimeSource.system()));
    }

    private static byte[] picture(String format, int width, Color color) {
        BufferedImage image = new BufferedImage(width, 8, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, color.getRGB());
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, format, file);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
        return file.toByteArray();
    }

    private int shownWidth() {
        CompletableFuture<Integer> width = new CompletableFuture<>();
        SwingUtilities.invokeLater(() -> width.complete(
                camera.view().image().map(BufferedImage::getWidth).orElse(0)));
        return WaitLimit.join("the picture", width);
    }

    @Test
    void pictureOfBothFormatsAreShown() {
        camera.see(() -> picture("jpeg", 16, Color.RED));
        WindowWait.await("the picture", () -> shownWidth() == 16);
        camera.see(() -> picture("png", 24, Color.RED));
        WindowWait.await("the picture", () -> shownWidth() == 24);
    }

    @Test
    void ofPicturesThatComeTooFastOnlyTheNewestIsDecoded() {
        CountDownLatch released = new CountDownLatch(1);
        CountDownLatch begun = new CountDownLatch(1);
        AtomicInteger decoded = new AtomicInteger();
        camera.see(() -> {
            begun.countDown();
            await(released);
            return picture("jpeg", 16, Color.RED);
        });
        await(begun);
        for (int width = 17; width <= 40; width++) {
            int number = width;
            camera.see(() -> {
                decoded.incrementAndGet();
                return picture("jpeg", number, Color.RED);
            });
        }
        released.countDown();
        WindowWait.await("the newest picture", () -> shownWidth() == 40);
        assertThat(decoded).hasValue(1);
    }

    @Test
    void aDamagedPictureIsSaidOverTheLastOne() {
        camera.see(() -> picture("jpeg", 16, Color.RED));
        WindowWait.await("the picture", () -> shownWidth() == 16);
        camera.see(() -> new byte[] {1, 2, 3});
        WindowWait.await("the reason", () -> accessibleName().contains("neither JPEG nor PNG"));
        assertThat(shownWidth()).isEqualTo(16);
    }

    private String accessibleName() {
        CompletableFuture<String> name = new CompletableFuture<>();
        SwingUtilities.invokeLater(
                () -> name.complete(camera.view().getAccessibleContext().getAccessibleName()));
        return WaitLimit.join("the picture", name);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aPngIsRecordedAsJpegAndAJpegAsItIs() throws IOException {
        byte[] jpeg = picture("jpeg", 16, Color.RED);
        assertThat(RosPictureFile.jpeg(jpeg)).isSameAs(jpeg);
        byte[] converted = RosPictureFile.jpeg(picture("png", 24, Color.RED));
        assertThat(converted).startsWith(0xFF, 0xD8);
        assertThat(PictureFile.decode(converted).getWidth()).isEqualTo(24);
        byte[] rubbish = {1, 2, 3};
        assertThat(RosPictureFile.jpeg(rubbish)).isSameAs(rubbish);
    }
}

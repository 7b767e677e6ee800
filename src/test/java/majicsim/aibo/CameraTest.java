package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import majicsim.world.Body;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the camera shows, and how (URBI sheet, sections 12 and 13). */
class CameraTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @ParameterizedTest
    @CsvSource({"0, 208, 160, 99840", "1, 104, 80, 24960", "2, 52, 40, 6240"})
    void eachResolutionHasItsSizeInBothFormats(int resolution, int width, int height, int bytes) throws IOException {
        client.ask("camera.resolution = " + resolution + ";");

        assertThat(header("camera.raw;")).isEqualTo("BIN %d YCbCr %d %d %3$d", bytes, width, height);
        assertThat(client.ask("camera.width; camera.height;"))
                .containsExactly("[notag] " + width + ".000000", "[notag] " + height + ".000000");
        BufferedImage image = picture();
        assertThat(image.getWidth()).isEqualTo(width);
        assertThat(image.getHeight()).isEqualTo(height);
    }

    @Test
    void theFormatActsFromTheNextCycleOn() {
        client.say("camera.format = 0; camera.val;");
        assertThat(client.raw()).contains("jpeg 208 160 160\n");

        client.ask("noop; noop;");

        assertThat(header("camera.val;")).isEqualTo("BIN 99840 YCbCr 208 160 160");
    }

    @Test
    void aSmallerFactorMakesSmallerPictures() {
        bench.world().add(Body.box("pioneer", 200, 200, 200, new Pose(900, 0, 30)));
        int fine = size("camera.val;");
        client.ask("camera.jpegfactor = 20;");

        assertThat(size("camera.val;")).isLessThan(fine * 3 / 4);
    }

    @Test
    void aRobotAppearsInThePictureAtItsPlace() throws IOException {
        bench.world().add(Body.box("pioneer", 200, 200, 200, new Pose(1200, 300, 0)));

        BufferedImage image = picture();

        assertThat(isRed(image.getRGB(60, 78))).isTrue();
        assertThat(isRed(image.getRGB(150, 78))).isFalse();
    }

    @Test
    void aRobotThatHasMovedIsNoLongerAtItsOldPlaceInThePicture() throws IOException {
        Body pioneer = Body.box("pioneer", 200, 200, 200, new Pose(1200, 300, 0));
        bench.world().add(pioneer);
        assertThat(isRed(picture().getRGB(60, 78))).isTrue();

        pioneer.place(new Pose(1200, -300, 0));
        client.ask("noop; noop;");

        BufferedImage image = picture();
        assertThat(isRed(image.getRGB(60, 78))).isFalse();
        assertThat(isRed(image.getRGB(150, 78))).isTrue();
    }

    @Test
    void whatIsSeenGoesRightWhenTheHeadGoesLeft() throws IOException {
        bench.world().add(Body.box("pioneer", 200, 200, 200, new Pose(1500, 0, 0)));
        int before = redMiddle(picture());

        client.ask("motors on; headPan = 15;", 500);

        assertThat(redMiddle(picture())).isBetween(before + 40, before + 70);
    }

    @Test
    void whatIsSeenGoesDownWhenTheHeadIsRaised() throws IOException {
        bench.world().add(Body.box("pioneer", 200, 200, 200, new Pose(1500, 0, 0)));
        boolean before = isRed(picture().getRGB(104, 80));

        client.ask("motors on; headTilt = 20;", 500);

        BufferedImage raised = picture();
        assertThat(before).isTrue();
        assertThat(isRed(raised.getRGB(104, 80))).isFalse();
        assertThat(isRed(raised.getRGB(104, 150))).isTrue();
    }

    @Test
    void aFastShutterAndLowGainMakeItDarker() throws IOException {
        int bright = picture().getRGB(104, 150) & 0xFF;

        client.ask("camera.shutter = 3; camera.gain = 1;");

        assertThat(picture().getRGB(104, 150) & 0xFF).isLessThan(bright / 2);
    }

    @Test
    void thirtyPicturesASecondAreTaken() {
        String first = bytes("camera.raw;");
        bench.world().add(Body.box("pioneer", 200, 200, 200, new Pose(900, 0, 0)));
        String same = bytes("camera.raw;");
        bench.run(36);

        assertThat(same).isEqualTo(first);
        assertThat(bytes("camera.raw;")).isNotEqualTo(first);
    }

    private BufferedImage picture() throws IOException {
        byte[] file = bytes("camera.val;").getBytes(StandardCharsets.ISO_8859_1);
        return ImageIO.read(new ByteArrayInputStream(file));
    }

    private String header(String question) {
        return answer(question).split("\n", 2)[0];
    }

    private int size(String question) {
        return bytes(question).length();
    }

    private String bytes(String question) {
        return answer(question).split("\n", 2)[1];
    }

    private String answer(String question) {
        client.say(question);
        return client.raw().substring("[00000000:notag] ".length());
    }

    private static int redMiddle(BufferedImage image) {
        int sum = 0;
        int count = 0;
        for (int column = 0; column < image.getWidth(); column++) {
            if (isRed(image.getRGB(column, image.getHeight() / 2))) {
                sum += column;
                count++;
            }
        }
        return sum / Math.max(1, count);
    }

    private static boolean isRed(int rgb) {
        return (rgb >> 16 & 0xFF) > 2 * (rgb >> 8 & 0xFF);
    }
}

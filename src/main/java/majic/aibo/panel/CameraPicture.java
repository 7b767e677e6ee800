package majic.aibo.panel;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import javax.imageio.ImageIO;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiValue;
import majic.driver.RobotWait;
import majic.panel.PictureFile;
import majic.text.Texts;

/** Turns what the dog's camera sends into pictures: a JFIF file, or three bytes for each pixel (URBI sheet 12). */
public final class CameraPicture {
    private static final Texts TEXTS = Texts.of(CameraPicture.class);
    /** Many times what the camera has; more is damage. */
    private static final int MOST_PIXELS = 2_000_000;

    private static final int BYTES_PER_PIXEL = 3;

    private CameraPicture() {}

    /**
     * A picture.
     *
     * @throws UrbiRefusal if it is none, or a damaged one; the message names which
     */
    static BufferedImage of(UrbiValue value) {
        if (!(value instanceof UrbiValue.Binary binary) || binary.words().isEmpty()) {
            throw new UrbiRefusal(TEXTS.get("picture.none"));
        }
        return switch (binary.words().get(0)) {
            case "jpeg" -> jpeg(binary.bytes());
            case "YCbCr" -> yCbCr(binary);
            default ->
                throw new UrbiRefusal(
                        TEXTS.get("picture.unknown", binary.words().get(0)));
        };
    }

    /**
     * A picture as a file in the JPEG format: the one that the dog sent, or one made of its pixels.
     *
     * @throws UrbiRefusal if it is none, or a damaged one; the message names which
     */
    public static byte[] jpegFile(UrbiValue value) {
        if (value instanceof UrbiValue.Binary binary && binary.words().contains("jpeg")) {
            return binary.bytes();
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try {
            ImageIO.write(of(value), "jpeg", file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return file.toByteArray();
    }

    /**
     * Asks the dog for a picture and waits for it.
     *
     * @return a JPEG file
     * @throws UrbiRefusal if none comes in time, or it is damaged
     * @throws majic.bot.LinkLost if the connection is lost
     */
    public static byte[] take(UrbiConnection from, RobotWait waiting) {
        UrbiValue picture = new Camera(waiting).next(from, () -> false);
        return jpegFile(Objects.requireNonNull(picture));
    }

    private static BufferedImage jpeg(byte[] bytes) {
        try {
            return PictureFile.decode(bytes);
        } catch (IOException e) {
            throw new UrbiRefusal(e.getMessage());
        }
    }

    private static BufferedImage yCbCr(UrbiValue.Binary binary) {
        int width = number(binary.words(), 1);
        int height = number(binary.words(), 2);
        check(width, height);
        byte[] bytes = binary.bytes();
        int wanted = BYTES_PER_PIXEL * width * height;
        if (bytes.length != wanted) {
            throw new UrbiRefusal(TEXTS.get("picture.short", bytes.length, wanted));
        }
        int[] pixels = new int[width * height];
        for (int pixel = 0; pixel < pixels.length; pixel++) {
            int at = BYTES_PER_PIXEL * pixel;
            pixels[pixel] = rgb(bytes[at] & 0xFF, (bytes[at + 1] & 0xFF) - 128, (bytes[at + 2] & 0xFF) - 128);
        }
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, width, height, pixels, 0, width);
        return image;
    }

    /** The conversion of JFIF. */
    private static int rgb(int luma, int blue, int red) {
        return clip(luma + 1.402 * red) << 16
                | clip(luma - 0.344136 * blue - 0.714136 * red) << 8
                | clip(luma + 1.772 * blue);
    }

    private static int clip(double channel) {
        return (int) Math.max(0, Math.min(255, Math.round(channel)));
    }

    private static int number(List<String> words, int index) {
        try {
            return index < words.size() ? Integer.parseInt(words.get(index)) : 0;
        } catch (NumberFormatException e) {
            return 0;
        }
    }

    private static void check(int width, int height) {
        if (width <= 0 || height <= 0 || (long) width * height > MOST_PIXELS) {
            throw new UrbiRefusal(TEXTS.get("picture.size", width, height));
        }
    }
}

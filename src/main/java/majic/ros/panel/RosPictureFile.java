package majic.ros.panel;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;
import majic.panel.PictureFile;

/** Turns pictures of cameras into the format of recordings. May be used on any thread. */
public final class RosPictureFile {
    private static final int FIRST = 0xFF;
    private static final int SECOND = 0xD8;

    private RosPictureFile() {}

    /**
     * Returns a picture as a JPEG file; takes some milliseconds for another format.
     *
     * @param file as the robot sent it
     * @return the same bytes if they begin as a JPEG file does, or if they are no picture at all
     */
    public static byte[] jpeg(byte[] file) {
        if (file.length > 1 && (file[0] & 0xFF) == FIRST && (file[1] & 0xFF) == SECOND) {
            return file;
        }
        try {
            return encoded(PictureFile.decode(file));
        } catch (IOException e) {
            return file;
        }
    }

    /** JPEG has no transparency. */
    private static byte[] encoded(BufferedImage image) {
        BufferedImage opaque = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = opaque.createGraphics();
        pen.drawImage(image, 0, 0, null);
        pen.dispose();
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try {
            ImageIO.write(opaque, "jpeg", file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return file.toByteArray();
    }
}

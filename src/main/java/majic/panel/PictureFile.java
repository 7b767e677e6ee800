package majic.panel;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import majic.text.Texts;

/** Decodes picture files of cameras, which may be damaged or claim any size. May be used on any thread. */
public final class PictureFile {
    private static final Texts TEXTS = Texts.of(PictureFile.class);

    /** More than cameras of robots have; more would cost much memory. */
    private static final int MOST_PIXELS = 4_000_000;

    private PictureFile() {}

    /**
     * Decodes a picture; takes some milliseconds.
     *
     * @param file in the format JPEG or PNG
     * @return the picture, in the format that windows draw with the least work; {@code TYPE_INT_RGB} unless it has
     *     transparent pixels
     * @throws IOException if it is no such file, damaged, cut off, or has more than four million pixels; the message
     *     says which, in the user's language
     */
    public static BufferedImage decode(byte[] file) throws IOException {
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new IOException(TEXTS.get("picture.unreadable"));
            }
            return decode(readers.next(), in);
        }
    }

    private static BufferedImage decode(ImageReader reader, ImageInputStream in) throws IOException {
        try {
            reader.setInput(in, true, true);
            reader.addIIOReadWarningListener((source, warning) -> {
                throw new IllegalStateException(warning);
            });
            if (isTooLarge(reader.getWidth(0), reader.getHeight(0))) {
                throw new IOException(TEXTS.get("picture.size", reader.getWidth(0), reader.getHeight(0)));
            }
            return quicklyDrawn(reader.read(0));
        } catch (IIOException | RuntimeException e) {
            throw new IOException(TEXTS.get("picture.damaged", e.getMessage()), e);
        } finally {
            reader.dispose();
        }
    }

    /**
     * Converts pixels of three bytes, as JPEG files have them, here: a window would convert them at each drawing, on
     * the event dispatch thread, which takes it twice as long as the drawing itself.
     */
    private static BufferedImage quicklyDrawn(BufferedImage decoded) {
        if (decoded.getColorModel().hasAlpha() || decoded.getType() == BufferedImage.TYPE_INT_RGB) {
            return decoded;
        }
        BufferedImage converted =
                new BufferedImage(decoded.getWidth(), decoded.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = converted.createGraphics();
        pen.drawImage(decoded, 0, 0, null);
        pen.dispose();
        return converted;
    }

    private static boolean isTooLarge(int width, int height) {
        return width <= 0 || height <= 0 || (long) width * height > MOST_PIXELS;
    }
}

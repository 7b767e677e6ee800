package majicsim.aibo;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * A picture that was taken, row by row from the upper left corner.
 *
 * @param rgb one number a pixel: 0xRRGGBB
 */
record Picture(int width, int height, int[] rgb) {

    /** As JFIF file; bytes are characters of the same number. */
    String jpeg(int factor) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam param = writer.getDefaultWriteParam();
            param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            param.setCompressionQuality(factor / 100f);
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image(), null, null), param);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write to memory", e);
        } finally {
            writer.dispose();
        }
        return bytes.toString(StandardCharsets.ISO_8859_1);
    }

    /** The pixels themselves as an image, not a copy. */
    private BufferedImage image() {
        DirectColorModel colors = new DirectColorModel(24, 0xFF0000, 0xFF00, 0xFF);
        WritableRaster raster = Raster.createPackedRaster(
                new DataBufferInt(rgb, rgb.length), width, height, width, colors.getMasks(), null);
        return new BufferedImage(colors, raster, false, null);
    }

    /** Three bytes a pixel: Y, Cb, Cr, all over the whole range of a byte as in JFIF. */
    String yCbCr() {
        byte[] bytes = new byte[3 * rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            double red = rgb[i] >> 16 & 0xFF;
            double green = rgb[i] >> 8 & 0xFF;
            double blue = rgb[i] & 0xFF;
            double luma = 0.299 * red + 0.587 * green + 0.114 * blue;
            bytes[3 * i] = (byte) Math.rint(luma);
            bytes[3 * i + 1] = level(128 + 0.564 * (blue - luma));
            bytes[3 * i + 2] = level(128 + 0.713 * (red - luma));
        }
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private static byte level(double value) {
        return (byte) Math.max(0, Math.min(255, Math.rint(value)));
    }
}

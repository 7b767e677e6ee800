package majicsim.aibo.camera;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
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

/** A picture that was taken, row by row from the upper left corner. It keeps its last file. */
final class Picture {
    private static final int CHANNELS = 3;

    private final int width;
    private final int height;
    private final int[] rgb;
    private String jpeg = "";
    private int jpegFactor;

    /** @param rgb one number a pixel: 0xRRGGBB */
    Picture(int width, int height, int[] rgb) {
        this.width = width;
        this.height = height;
        this.rgb = rgb;
    }

    /** As JFIF file; bytes are characters of the same number. */
    String jpeg(int factor) {
        if (jpeg.isEmpty() || jpegFactor != factor) {
            jpeg = encoded(factor);
            jpegFactor = factor;
        }
        return jpeg;
    }

    private String encoded(int factor) {
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

    /** The pixels in bytes side by side, the only order that the writer takes without converting each line. */
    private BufferedImage image() {
        WritableRaster raster = Raster.createInterleavedRaster(DataBuffer.TYPE_BYTE, width, height, CHANNELS, null);
        byte[] bytes = ((DataBufferByte) raster.getDataBuffer()).getData();
        for (int i = 0; i < rgb.length; i++) {
            bytes[CHANNELS * i] = (byte) (rgb[i] >> 16);
            bytes[CHANNELS * i + 1] = (byte) (rgb[i] >> 8);
            bytes[CHANNELS * i + 2] = (byte) rgb[i];
        }
        ColorSpace sRgb = ColorSpace.getInstance(ColorSpace.CS_sRGB);
        ColorModel colors = new ComponentColorModel(sRgb, false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE);
        return new BufferedImage(colors, raster, false, null);
    }

    /** Three bytes a pixel: Y, Cb, Cr, all over the whole range of a byte as in JFIF. */
    String yCbCr() {
        byte[] bytes = new byte[CHANNELS * rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            double red = rgb[i] >> 16 & 0xFF;
            double green = rgb[i] >> 8 & 0xFF;
            double blue = rgb[i] & 0xFF;
            double luma = 0.299 * red + 0.587 * green + 0.114 * blue;
            bytes[CHANNELS * i] = (byte) Math.rint(luma);
            bytes[CHANNELS * i + 1] = level(128 + 0.564 * (blue - luma));
            bytes[CHANNELS * i + 2] = level(128 + 0.713 * (red - luma));
        }
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private static byte level(double value) {
        return (byte) Math.max(0, Math.min(255, Math.rint(value)));
    }
}

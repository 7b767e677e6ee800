package majicsim.ros.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** A message as the pixels of a PNG picture, three bytes each, filled up with line ends (sheet 3). */
final class PngForm {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    private static final int CHANNELS = 3;
    private static final byte[] EIGHT_BITS_RGB = {8, 2, 0, 0, 0};

    private final byte[] text;

    PngForm(byte[] text) {
        this.text = text;
    }

    void write(JsonGenerator to) throws IOException {
        to.writeStartObject();
        to.writeStringField("op", "png");
        to.writeStringField("data", Base64.getEncoder().encodeToString(picture()));
        to.writeEndObject();
    }

    private byte[] picture() throws IOException {
        int width = Math.max(1, (int) Math.sqrt(text.length / (double) CHANNELS));
        int rowBytes = CHANNELS * width;
        int height = (text.length + rowBytes - 1) / rowBytes;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream picture = new DataOutputStream(bytes);
        picture.write(SIGNATURE);
        chunk(
                picture,
                "IHDR",
                ByteBuffer.allocate(13)
                        .putInt(width)
                        .putInt(height)
                        .put(EIGHT_BITS_RGB)
                        .array());
        chunk(picture, "IDAT", pixels(rowBytes, height));
        chunk(picture, "IEND", new byte[0]);
        return bytes.toByteArray();
    }

    private byte[] pixels(int rowBytes, int height) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflated = new DeflaterOutputStream(bytes, new Deflater())) {
            for (int row = 0; row < height; row++) {
                deflated.write(0);
                for (int i = row * rowBytes; i < (row + 1) * rowBytes; i++) {
                    deflated.write(i < text.length ? text[i] : '\n');
                }
            }
        }
        return bytes.toByteArray();
    }

    private static void chunk(DataOutputStream to, String name, byte[] content) throws IOException {
        byte[] letters = name.getBytes(StandardCharsets.US_ASCII);
        CRC32 crc = new CRC32();
        crc.update(letters);
        crc.update(content);
        to.writeInt(content.length);
        to.write(letters);
        to.write(content);
        to.writeInt((int) crc.getValue());
    }
}

package majic.aibo.sound;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;

/** WAV files for tests, by the Java library and by hand. */
public final class Sounds {
    private Sounds() {}

    /** What the Java library makes of raw bytes. */
    public static byte[] wav(AudioFormat format, byte[] bytes) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        long frames = bytes.length / format.getFrameSize();
        try {
            AudioSystem.write(
                    new AudioInputStream(new ByteArrayInputStream(bytes), format, frames),
                    AudioFileFormat.Type.WAVE,
                    file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return file.toByteArray();
    }

    /** So many seconds of 16 bits on one channel, each sample made of its index. */
    public static byte[] wav(int rateHz, double seconds) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * (int) (rateHz * seconds)).order(ByteOrder.LITTLE_ENDIAN);
        for (int index = 0; bytes.hasRemaining(); index++) {
            bytes.putShort((short) (index * 7919));
        }
        return wav(new AudioFormat(rateHz, 16, 1, true, false), bytes.array());
    }

    /** A chunk of a RIFF file with the given length in its header. */
    static byte[] chunk(String kind, int saidLength, byte... content) {
        return ByteBuffer.allocate(8 + content.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put(kind.getBytes(StandardCharsets.US_ASCII))
                .putInt(saidLength)
                .put(content)
                .array();
    }

    /** The chunk that describes a sound of one channel. */
    static byte[] format(int encoding, int rateHz, int bits) {
        ByteBuffer content = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
        content.putShort((short) encoding).putShort((short) 1).putInt(rateHz).putInt(rateHz * bits / 8);
        content.putShort((short) (bits / 8)).putShort((short) bits);
        return chunk("fmt ", 16, content.array());
    }

    /** A RIFF file of chunks. */
    static byte[] riff(byte[]... chunks) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.writeBytes("RIFF\0\0\0\0WAVE".getBytes(StandardCharsets.US_ASCII));
        for (byte[] chunk : chunks) {
            file.writeBytes(chunk);
        }
        return file.toByteArray();
    }
}

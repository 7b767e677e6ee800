package majicsim.aibo.sound;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.function.DoubleUnaryOperator;

/** A sound as the dog's speaker plays it: one channel, 16000 samples a second, 16 bit. Immutable. */
public final class Sound {
    /** Samples a second. */
    public static final int RATE_HZ = 16_000;

    private static final double PER_MS = RATE_HZ / 1000.0;
    private static final int WAV_HEADER = 44;

    private final short[] samples;

    /** @param samples its own from now on */
    Sound(short[] samples) {
        this.samples = samples;
    }

    /** A sound from its waveform: -1 to 1 over seconds. */
    static Sound of(double lengthMs, DoubleUnaryOperator course) {
        short[] samples = new short[(int) (lengthMs * PER_MS)];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) (Short.MAX_VALUE * course.applyAsDouble(i / (double) RATE_HZ));
        }
        return new Sound(samples);
    }

    /**
     * Its length.
     *
     * @return ms
     */
    public double lengthMs() {
        return samples.length / PER_MS;
    }

    /**
     * Its waveform.
     *
     * @param index of the sample, 16000 a second from 0 on
     * @return -32768 to 32767; 0 before its beginning and behind its end
     */
    public int sample(int index) {
        return index >= 0 && index < samples.length ? samples[index] : 0;
    }

    /** As a RIFF file; bytes are characters of the same number. */
    String wav() {
        int size = 2 * samples.length;
        ByteBuffer file = ByteBuffer.allocate(WAV_HEADER + size).order(ByteOrder.LITTLE_ENDIAN);
        file.put(ascii("RIFF"))
                .putInt(WAV_HEADER - 8 + size)
                .put(ascii("WAVEfmt "))
                .putInt(16);
        file.putShort((short) 1).putShort((short) 1).putInt(RATE_HZ).putInt(2 * RATE_HZ);
        file.putShort((short) 2).putShort((short) 16).put(ascii("data")).putInt(size);
        file.asShortBuffer().put(samples);
        return new String(file.array(), StandardCharsets.ISO_8859_1);
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}

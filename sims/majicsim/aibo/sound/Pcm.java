package majicsim.aibo.sound;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * Sampled sound in a binary (URBI sheet, section 12). The speaker takes 16 kHz with 16 bit and 8 kHz with 8 bit,
 * nothing else.
 *
 * @param signed whether 8-bit samples have a sign; those of 16 bit always have
 */
record Pcm(int channels, int rateHz, int bits, boolean signed, byte[] data) {
    private static final String RIFF = "RIFF";
    private static final int FIRST_CHUNK = 12;
    private static final int CHUNK_HEADER = 8;

    /** The sound in a binary, or null if the speaker cannot play it. */
    static @Nullable Sound sound(Value.Binary binary) {
        byte[] bytes = binary.bytes().getBytes(StandardCharsets.ISO_8859_1);
        Pcm pcm = binary.bytes().startsWith(RIFF) ? riff(bytes) : raw(binary.parameters(), bytes);
        return pcm == null || !pcm.isPlayable() ? null : pcm.mixed();
    }

    private boolean isPlayable() {
        boolean known = rateHz == 16_000 && bits == 16 || rateHz == 8_000 && bits == 8;
        return known && (channels == 1 || channels == 2);
    }

    /** {@code raw channels rate bits signed}, the last 1 for signed and 2 for unsigned. */
    private static @Nullable Pcm raw(String parameters, byte[] bytes) {
        String[] words = parameters.trim().split("\\s+");
        if (words.length < 5) {
            return null;
        }
        try {
            int[] numbers =
                    Arrays.stream(words).skip(1).mapToInt(Integer::parseInt).toArray();
            return new Pcm(numbers[0], numbers[1], numbers[2], numbers[3] == 1, bytes);
        } catch (NumberFormatException e) {
            return null;
        }
    }

    private static @Nullable Pcm riff(byte[] bytes) {
        ByteBuffer file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int format = -1;
        long at = FIRST_CHUNK;
        while (at + CHUNK_HEADER <= bytes.length) {
            int start = (int) at;
            long size = Integer.toUnsignedLong(file.getInt(start + 4));
            String name = new String(bytes, start, 4, StandardCharsets.ISO_8859_1);
            int body = start + CHUNK_HEADER;
            if (name.equals("fmt ") && body + 16 <= bytes.length) {
                format = body;
            } else if (name.equals("data") && format >= 0) {
                byte[] data = Arrays.copyOfRange(bytes, body, (int) Math.min(bytes.length, body + size));
                return new Pcm(
                        file.getShort(format + 2), file.getInt(format + 4), file.getShort(format + 14), false, data);
            }
            at = body + size + size % 2;
        }
        return null;
    }

    /** All channels in one, at the speaker's own rate. */
    private Sound mixed() {
        int repeat = Sound.RATE_HZ / rateHz;
        int frames = data.length / (channels * bits / 8);
        short[] samples = new short[frames * repeat];
        for (int i = 0; i < samples.length; i++) {
            int sum = 0;
            for (int channel = 0; channel < channels; channel++) {
                sum += sample(i / repeat * channels + channel);
            }
            samples[i] = (short) (sum / channels);
        }
        return new Sound(samples);
    }

    private int sample(int number) {
        if (bits == 16) {
            return data[2 * number] & 0xFF | data[2 * number + 1] << 8;
        }
        return (signed ? data[number] : (data[number] & 0xFF) - 128) << 8;
    }
}

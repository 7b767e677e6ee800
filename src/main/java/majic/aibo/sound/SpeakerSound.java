package majic.aibo.sound;

import java.util.Arrays;

/**
 * A sound as the dog's speaker takes it: one channel, 16 kHz, 16 bits (URBI sheet 12), in pieces that it can be sent
 * in. Immutable.
 */
final class SpeakerSound {
    static final int RATE_HZ = 16_000;

    /** The description of the bytes for the dog: channels, rate, bits, signed. */
    static final String FORMAT = "raw 1 16000 16 1";

    private static final int LONGEST_PIECE = 12_000;
    private static final int SHORTEST_PIECE = 8_000;
    private static final int HUSH = 160;

    private final short[] samples;

    private SpeakerSound(short[] samples) {
        this.samples = samples;
    }

    /** Converts a sound. What is too fine for the speaker is averaged, what is too coarse is drawn through. */
    static SpeakerSound of(Pcm sound) {
        double[] source = sound.mono();
        double step = (double) sound.format().rateHz() / RATE_HZ;
        short[] samples = new short[(int) Math.max(1, source.length / step)];
        double[] sums = step > 1 ? sums(source) : source;
        for (int index = 0; index < samples.length; index++) {
            double from = index * step;
            samples[index] = Pcm.sixteenBits(step > 1 ? mean(source, sums, from, from + step) : between(source, from));
        }
        return new SpeakerSound(samples);
    }

    private static double[] sums(double[] source) {
        double[] sums = new double[source.length + 1];
        for (int index = 0; index < source.length; index++) {
            sums[index + 1] = sums[index] + source[index];
        }
        return sums;
    }

    private static double mean(double[] source, double[] sums, double from, double to) {
        return (sumUpTo(source, sums, to) - sumUpTo(source, sums, from)) / (to - from);
    }

    private static double sumUpTo(double[] source, double[] sums, double place) {
        int whole = (int) Math.min(source.length, place);
        return sums[whole] + (whole < source.length ? (place - whole) * source[whole] : 0);
    }

    private static double between(double[] source, double place) {
        int left = (int) Math.min(source.length - 1, place);
        int right = Math.min(source.length - 1, left + 1);
        return source[left] + (place - left) * (source[right] - source[left]);
    }

    int length() {
        return samples.length;
    }

    double seconds() {
        return seconds(0, samples.length);
    }

    static double seconds(int from, int end) {
        return (double) (end - from) / RATE_HZ;
    }

    /**
     * Where a piece that begins here is to end: at half to three quarters of a second, in the quietest place, since the
     * next piece begins a moment after the end of this one.
     */
    int endOfPiece(int from) {
        if (samples.length - from <= LONGEST_PIECE) {
            return samples.length;
        }
        int best = from + SHORTEST_PIECE;
        for (int place = best; place + HUSH <= from + LONGEST_PIECE; place += HUSH) {
            best = loudness(place) < loudness(best) ? place : best;
        }
        return best + HUSH / 2;
    }

    private long loudness(int place) {
        long sum = 0;
        for (short sample : Arrays.copyOfRange(samples, place, place + HUSH)) {
            sum += Math.abs(sample);
        }
        return sum;
    }

    /** A stretch of it as it is sent, at a share of its loudness. */
    byte[] bytes(int from, int end, double share) {
        byte[] bytes = new byte[2 * (end - from)];
        for (int index = from; index < end; index++) {
            Pcm.put(bytes, 2 * (index - from), (short) Math.rint(samples[index] * share));
        }
        return bytes;
    }
}

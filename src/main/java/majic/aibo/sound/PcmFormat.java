package majic.aibo.sound;

/**
 * How uncompressed sound is laid out in bytes, little-endian. Immutable.
 *
 * @param channels how many samples stand side by side for one moment
 * @param rateHz moments in a second
 * @param bits of one sample: 8, 16, 24 or 32
 * @param coding what the bits mean
 */
record PcmFormat(int channels, int rateHz, int bits, Coding coding) {
    private static final int SLOWEST_HZ = 1000;
    private static final int FASTEST_HZ = 192_000;
    private static final int MOST_CHANNELS = 32;

    /** What the bits of a sample mean. */
    enum Coding {
        SIGNED,
        UNSIGNED,
        FLOAT
    }

    /** Whether it can be played; the format in a damaged header may not be. */
    boolean isSensible() {
        boolean known = coding == Coding.FLOAT ? bits == 32 : bits == 8 || bits == 16 || bits == 24 || bits == 32;
        return known && channels >= 1 && channels <= MOST_CHANNELS && rateHz >= SLOWEST_HZ && rateHz <= FASTEST_HZ;
    }

    int sampleBytes() {
        return bits / 8;
    }

    /** The bytes of one moment. */
    int frameBytes() {
        return channels * sampleBytes();
    }

    /** A sample as a number from −1 to 1. */
    double sample(byte[] bytes, int at) {
        int value = 0;
        for (int index = 0; index < sampleBytes(); index++) {
            value |= (bytes[at + index] & 0xFF) << 32 - bits + 8 * index;
        }
        return switch (coding) {
            case SIGNED -> value / 0x1p31;
            case UNSIGNED -> (value ^ Integer.MIN_VALUE) / 0x1p31;
            case FLOAT -> bounded(Float.intBitsToFloat(value));
        };
    }

    private static double bounded(float amount) {
        return Float.isNaN(amount) ? 0 : Math.max(-1, Math.min(1, amount));
    }
}

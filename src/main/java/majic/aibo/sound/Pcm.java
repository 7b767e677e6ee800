package majic.aibo.sound;

/**
 * Uncompressed sound.
 *
 * @param format how its bytes are laid out; a sensible one
 * @param bytes whole frames; not to be changed
 */
record Pcm(PcmFormat format, byte[] bytes) {
    int frames() {
        return bytes.length / format.frameBytes();
    }

    double seconds() {
        return (double) frames() / format.rateHz();
    }

    /** Each moment as the mean of its channels, −1 to 1. */
    double[] mono() {
        double[] mono = new double[frames()];
        for (int frame = 0; frame < mono.length; frame++) {
            double sum = 0;
            for (int channel = 0; channel < format.channels(); channel++) {
                sum += format.sample(bytes, frame * format.frameBytes() + channel * format.sampleBytes());
            }
            mono[frame] = sum / format.channels();
        }
        return mono;
    }

    /** The same as signed samples of 16 bits. */
    Pcm in16Bits() {
        PcmFormat plain = new PcmFormat(format.channels(), format.rateHz(), 16, PcmFormat.Coding.SIGNED);
        if (format.equals(plain)) {
            return this;
        }
        int samples = frames() * format.channels();
        byte[] converted = new byte[2 * samples];
        for (int index = 0; index < samples; index++) {
            put(converted, 2 * index, sixteenBits(format.sample(bytes, index * format.sampleBytes())));
        }
        return new Pcm(plain, converted);
    }

    /** A sample of −1 to 1 as a signed number of 16 bits. */
    static short sixteenBits(double sample) {
        return (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.rint(sample * -Short.MIN_VALUE)));
    }

    /** Writes a sample of 16 bits, low byte first. */
    static void put(byte[] bytes, int at, short sample) {
        bytes[at] = (byte) sample;
        bytes[at + 1] = (byte) (sample >> 8);
    }
}

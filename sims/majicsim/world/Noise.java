package majicsim.world;

import java.util.Random;
import org.jspecify.annotations.Nullable;

/**
 * The only source of random numbers in a lab. The same seed and the same calls repeat a lab exactly; the exact source
 * returns means, and chances never occur. Guarded by the lab's lock.
 */
public final class Noise {
    private final long seed;
    private final @Nullable Random random;

    private Noise(long seed, @Nullable Random random) {
        this.seed = seed;
        this.random = random;
    }

    /**
     * No noise at all.
     *
     * @return a source that returns means
     */
    public static Noise exact() {
        return new Noise(0, null);
    }

    /**
     * Noise that repeats itself with its seed.
     *
     * @param seed any number
     * @return a new source at its beginning
     */
    public static Noise seeded(long seed) {
        return new Noise(seed, new UnsharedRandom(mixed(seed)));
    }

    /**
     * An independent stream for one consumer, so that further consumers do not change it. The same name from sources of
     * the same seed gives the same stream, independent of what was drawn before.
     *
     * @param name of the consumer
     * @return a stream of its own; exact if this is
     */
    public Noise fork(String name) {
        return random == null ? this : seeded(mixed(seed ^ ((long) name.hashCode() << 20)));
    }

    /**
     * Whether all noise is off.
     *
     * @return true for {@link #exact()}
     */
    public boolean isExact() {
        return random == null;
    }

    /**
     * A factor around 1.
     *
     * @param relativeSigma standard deviation, 0.05 for 5 %
     * @return the factor, at most three deviations from 1; exactly 1 if exact
     */
    public double scale(double relativeSigma) {
        return 1 + gaussian(relativeSigma);
    }

    /**
     * A normally distributed error.
     *
     * @param sigma standard deviation, in the caller's unit
     * @return an error around 0, at most three deviations; 0 if exact
     */
    public double gaussian(double sigma) {
        return random == null ? 0 : sigma * Math.max(-3, Math.min(3, random.nextGaussian()));
    }

    /**
     * A number from a range.
     *
     * @param from lower end
     * @param to upper end, not below the lower
     * @return a number of the range; its middle if exact
     */
    public double uniform(double from, double to) {
        return from + (to - from) * (random == null ? 0.5 : random.nextDouble());
    }

    /**
     * Whether a random event occurs now.
     *
     * @param probability 0 to 1
     * @return true with this probability; false if exact, unless the probability is 1
     */
    public boolean chance(double probability) {
        return random == null ? probability >= 1 : random.nextDouble() < probability;
    }

    private static long mixed(long value) {
        long z = value + 0x9E3779B97F4A7C15L;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /**
     * Draws the same numbers as {@link Random}, without its protection against other threads: callers hold the lab's
     * lock.
     */
    private static final class UnsharedRandom extends Random {
        private static final long serialVersionUID = 1;
        private static final long MULTIPLIER = 0x5DEECE66DL;
        private static final long MASK = (1L << 48) - 1;

        private long state;

        UnsharedRandom(long seed) {
            super(seed);
        }

        @Override
        public void setSeed(long seed) {
            super.setSeed(seed);
            state = (seed ^ MULTIPLIER) & MASK;
        }

        @Override
        protected int next(int bits) {
            state = (state * MULTIPLIER + 0xB) & MASK;
            return (int) (state >>> (48 - bits));
        }
    }
}

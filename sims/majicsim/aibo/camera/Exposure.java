package majicsim.aibo.camera;

import majicsim.world.Noise;

/**
 * The exposure of the camera's chip: scales the colours by the settings and adds grain. The grain is drawn once, and
 * each picture begins at one of a few places in it: a number drawn for each pixel would take longer than everything
 * else of a picture, and pictures of a scene in which nothing moves can be kept.
 */
final class Exposure {
    private static final int LEVELS = 256;
    private static final int STRONGEST = LEVELS - 1;

    /** At the highest gain, levels up or down. */
    private static final double GRAIN = 4;

    private static final int HIGHEST_GAIN = 3;

    /** About as many as a picture has pixels, so that no pattern is visible. */
    private static final int GRAINS = 1 << 15;

    /** How many different grains there are. */
    static final int PATTERNS = 8;

    private final Noise noise;
    private byte[] grains = {};

    Exposure(Noise noise) {
        this.noise = noise;
    }

    /** Draws the grain of the next picture, 0 to {@link #PATTERNS} - 1. */
    int drawPattern() {
        return Math.min(PATTERNS - 1, (int) noise.uniform(0, PATTERNS));
    }

    /** Returns the pixels, 0xRRGGBB, as the chip reports them. */
    int[] expose(int[] seen, CameraSettings settings, int pattern) {
        double[] factors = settings.exposure();
        int[] reds = levels(factors[0]);
        int[] greens = levels(factors[1]);
        int[] blues = levels(factors[2]);
        int strength = noise.isExact() ? 0 : (int) Math.round(GRAIN * settings.gain() / HIGHEST_GAIN * Byte.MAX_VALUE);
        byte[] grain = grains();
        int start = pattern * (GRAINS / PATTERNS);
        int[] rgb = new int[seen.length];
        for (int i = 0; i < rgb.length; i++) {
            int off = grain[start + i & GRAINS - 1] * strength >> 2 * (Byte.SIZE - 1);
            int pixel = seen[i];
            rgb[i] = clipped(reds[pixel >> Short.SIZE & STRONGEST] + off) << Short.SIZE
                    | clipped(greens[pixel >> Byte.SIZE & STRONGEST] + off) << Byte.SIZE
                    | clipped(blues[pixel & STRONGEST] + off);
        }
        return rgb;
    }

    private byte[] grains() {
        if (grains.length == 0) {
            grains = new byte[GRAINS];
            for (int i = 0; i < GRAINS; i++) {
                grains[i] = (byte) noise.uniform(Byte.MIN_VALUE, LEVELS + Byte.MIN_VALUE);
            }
        }
        return grains;
    }

    private static int[] levels(double factor) {
        int[] levels = new int[LEVELS];
        for (int level = 0; level < LEVELS; level++) {
            levels[level] = (int) Math.min(STRONGEST, level * factor);
        }
        return levels;
    }

    private static int clipped(int level) {
        return level < 0 ? 0 : Math.min(STRONGEST, level);
    }
}

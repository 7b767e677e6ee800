package majicsim.aibo.camera;

/**
 * The camera's settings for a picture (URBI sheet, section 13).
 *
 * @param format 0 YCbCr, 1 JPEG
 * @param resolution 0 (208 by 160) to 2 (52 by 40)
 * @param jpegFactor 0 to 100
 * @param shutter 1 slow to 3 fast
 * @param gain 1 low to 3 high
 * @param whiteBalance 1 indoor, 2 outdoor, 3 fluorescent
 */
record CameraSettings(int format, int resolution, int jpegFactor, int shutter, int gain, int whiteBalance) {
    static final CameraSettings DEFAULT = new CameraSettings(1, 0, 80, 1, 3, 1);
    private static final int WIDTH = 208;
    private static final int HEIGHT = 160;
    private static final double[] OPEN = {1, 0.7, 0.5};
    private static final double[] AMPLIFIED = {0.6, 0.8, 1};
    private static final double[][] TINTS = {{1, 1, 1}, {1.12, 1, 0.85}, {1.05, 0.92, 1.08}};

    int width() {
        return WIDTH >> resolution;
    }

    int height() {
        return HEIGHT >> resolution;
    }

    boolean isJpeg() {
        return format == 1;
    }

    /** How much brighter red, green and blue become than with the settings of the start. */
    double[] exposure() {
        double light = OPEN[shutter - 1] * AMPLIFIED[gain - 1];
        double[] tint = TINTS[whiteBalance - 1];
        return new double[] {light * tint[0], light * tint[1], light * tint[2]};
    }
}

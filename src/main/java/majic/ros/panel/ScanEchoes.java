package majic.ros.panel;

import java.util.Arrays;

/** The echoes of one scan, beam by beam, in the frame of the robot: x ahead, y to the left, mm. Immutable. */
public final class ScanEchoes {
    private final double[] xMm;
    private final double[] yMm;
    private final long atNanos;

    private ScanEchoes(double[] xMm, double[] yMm, long atNanos) {
        this.xMm = xMm;
        this.yMm = yMm;
        this.atNanos = atNanos;
    }

    /**
     * Makes a scan.
     *
     * @param xMm of each beam, ahead positive; NaN for a beam without an echo
     * @param yMm of each beam, left positive; NaN for a beam without an echo
     * @param atNanos when it arrived, on the robot's clock in MAJIC
     * @return the scan, with copies of both
     * @throws IllegalArgumentException if there are more of one than of the other
     */
    public static ScanEchoes of(double[] xMm, double[] yMm, long atNanos) {
        if (xMm.length != yMm.length) {
            throw new IllegalArgumentException(xMm.length + " x for " + yMm.length + " y");
        }
        return new ScanEchoes(xMm.clone(), yMm.clone(), atNanos);
    }

    int beams() {
        return xMm.length;
    }

    boolean hasEcho(int beam) {
        return !Double.isNaN(xMm[beam]) && !Double.isNaN(yMm[beam]);
    }

    double xMm(int beam) {
        return xMm[beam];
    }

    double yMm(int beam) {
        return yMm[beam];
    }

    long atNanos() {
        return atNanos;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ScanEchoes scan
                && atNanos == scan.atNanos
                && Arrays.equals(xMm, scan.xMm)
                && Arrays.equals(yMm, scan.yMm);
    }

    @Override
    public int hashCode() {
        return Long.hashCode(atNanos);
    }
}

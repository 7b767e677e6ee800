package majic.nav.localisation;

import majic.bot.Pose;

/**
 * Where a robot is on a map, and how certain that is. Immutable.
 *
 * @param pose the most likely pose
 * @param varianceXmm2 the variance of x, mm²
 * @param covarianceXYmm2 the covariance of x and y, mm²; with the variances, the ellipse of the place
 * @param varianceYmm2 the variance of y, mm²
 * @param sigmaDeg the standard deviation of the heading, deg
 * @param placed whether it may be relied on; false while a robot is looked for or has been lost
 */
public record PoseEstimate(
        Pose pose, double varianceXmm2, double covarianceXYmm2, double varianceYmm2, double sigmaDeg, boolean placed) {
    /** Returns the standard deviation in the direction in which the place is least certain, mm. */
    public double sigmaMm() {
        double mean = (varianceXmm2 + varianceYmm2) / 2;
        return Math.sqrt(mean + Math.hypot((varianceXmm2 - varianceYmm2) / 2, covarianceXYmm2));
    }
}

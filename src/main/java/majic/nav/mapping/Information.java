package majic.nav.mapping;

/**
 * A symmetric matrix of 3 × 3 over x, y (mm) and heading (rad): the information of a pose, or its inverse, the
 * covariance. Immutable.
 */
record Information(double xx, double xy, double xt, double yy, double yt, double tt) {
    static final Information NONE = new Information(0, 0, 0, 0, 0, 0);

    static Information diagonal(double xx, double yy, double tt) {
        return new Information(xx, 0, 0, yy, 0, tt);
    }

    /** The information of independent standard deviations. */
    static Information ofSigmas(double mm, double deg) {
        double rad = Math.toRadians(deg);
        return diagonal(1 / (mm * mm), 1 / (mm * mm), 1 / (rad * rad));
    }

    Information plus(Information other) {
        return new Information(
                xx + other.xx, xy + other.xy, xt + other.xt, yy + other.yy, yt + other.yt, tt + other.tt);
    }

    Information times(double factor) {
        return new Information(xx * factor, xy * factor, xt * factor, yy * factor, yt * factor, tt * factor);
    }

    double determinant() {
        return xx * (yy * tt - yt * yt) - xy * (xy * tt - yt * xt) + xt * (xy * yt - yy * xt);
    }

    /** The inverse; the matrix must be positive definite. */
    Information inverse() {
        double d = determinant();
        return new Information(
                (yy * tt - yt * yt) / d,
                (xt * yt - xy * tt) / d,
                (xy * yt - xt * yy) / d,
                (xx * tt - xt * xt) / d,
                (xy * xt - xx * yt) / d,
                (xx * yy - xy * xy) / d);
    }

    /** The same matrix in a frame whose axes are turned by the angle: R M Rᵀ. */
    Information turned(double rad) {
        double c = Math.cos(rad);
        double s = Math.sin(rad);
        return new Information(
                c * c * xx - 2 * c * s * xy + s * s * yy,
                c * s * (xx - yy) + (c * c - s * s) * xy,
                c * xt - s * yt,
                s * s * xx + 2 * c * s * xy + c * c * yy,
                s * xt + c * yt,
                tt);
    }

    /** The product with a vector. */
    double[] times(double x, double y, double t) {
        return new double[] {xx * x + xy * y + xt * t, xy * x + yy * y + yt * t, xt * x + yt * y + tt * t};
    }

    /** vᵀ M v. */
    double squared(double x, double y, double t) {
        double[] product = times(x, y, t);
        return x * product[0] + y * product[1] + t * product[2];
    }
}

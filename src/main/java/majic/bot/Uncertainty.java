package majic.bot;

/**
 * How far the true pose of a robot may be from the one it has on a map: the covariance of x, y and heading. Immutable.
 *
 * @param xx the variance of x, mm²
 * @param xy the covariance of x and y, mm²
 * @param yy the variance of y, mm²
 * @param xt the covariance of x and heading, mm rad
 * @param yt the covariance of y and heading, mm rad
 * @param tt the variance of the heading, rad²
 */
public record Uncertainty(double xx, double xy, double yy, double xt, double yt, double tt) {
    /** Of a robot that was never placed or is lost: nothing is known. */
    public static final Uncertainty UNKNOWN =
            new Uncertainty(Double.POSITIVE_INFINITY, 0, Double.POSITIVE_INFINITY, 0, 0, Double.POSITIVE_INFINITY);

    /** Of a robot that a person has placed, by a ruler or by dragging: 50 mm and 3 degrees. */
    public static final Uncertainty BY_HAND = of(50, 3);

    private static final double MM_PER_M = 100;
    /** Of a robot with odometry: the standard deviation of the heading after one metre, deg. */
    static final double DEG_PER_M = 3;

    private static final double SHARE_OF_TURN = 0.1;

    /** A turn of 360 degrees displaces the centre by some 50 mm. */
    private static final double MM_PER_TURN = 50;

    private static final double M = 1000;
    private static final double FULL_TURN = 360;

    /** The turn whose error is the share of it; a longer one is several of these. */
    private static final double ONE_TURN = 30;

    /**
     * The same uncertainty in each direction.
     *
     * @param sigmaMm the standard deviation of the place in each direction
     * @param sigmaDeg the standard deviation of the heading
     * @return without correlation
     */
    public static Uncertainty of(double sigmaMm, double sigmaDeg) {
        double variance = sigmaMm * sigmaMm;
        double sigmaRad = Math.toRadians(sigmaDeg);
        return new Uncertainty(variance, 0, variance, 0, 0, sigmaRad * sigmaRad);
    }

    /** Returns whether anything is known. */
    public boolean isKnown() {
        return xx < Double.POSITIVE_INFINITY;
    }

    /** Returns the standard deviation in the direction in which the place is least certain, mm; infinite if unknown. */
    public double sigmaMm() {
        return isKnown() ? Math.sqrt((xx + yy) / 2 + Math.hypot((xx - yy) / 2, xy)) : Double.POSITIVE_INFINITY;
    }

    /** Returns the standard deviation of the heading, deg; infinite if unknown. */
    public double sigmaDeg() {
        return Math.toDegrees(Math.sqrt(tt));
    }

    /**
     * Returns the variance of the place along a motion by wheel odometry, which grows with the way and the turn (Thrun,
     * Burgard, Fox 2005, 5.4): for each metre a standard deviation of 100 mm. Errors of motions that follow each other
     * are independent, so variances grow in proportion.
     *
     * @param wayMm the length of the way
     * @param turnDeg the turn, positive
     * @return mm²
     */
    public static double ofWay(double wayMm, double turnDeg) {
        return MM_PER_M * MM_PER_M * wayMm / M + MM_PER_TURN * MM_PER_TURN * turnDeg / FULL_TURN;
    }

    /**
     * Returns the variance of the heading after a motion by wheel odometry: for each metre a standard deviation of 3
     * degrees, for each turn of 30 degrees one of 10 %.
     *
     * @param wayMm the length of the way
     * @param turnDeg the turn, positive
     * @return rad²
     */
    public static double ofTurn(double wayMm, double turnDeg) {
        return ofTurn(wayMm, turnDeg, DEG_PER_M);
    }

    private static double ofTurn(double wayMm, double turnDeg, double degPerM) {
        double deg2 = degPerM * degPerM * wayMm / M + SHARE_OF_TURN * SHARE_OF_TURN * ONE_TURN * turnDeg;
        return deg2 * Math.pow(Math.toRadians(1), 2);
    }

    /**
     * Returns the uncertainty after a motion by odometry (propagation of a covariance; Siegwart and Nourbakhsh 2004,
     * 5.2.4).
     *
     * @param headingDeg the heading of the robot on the map before the motion
     * @param step the pose afterwards, seen from the one before
     * @return a larger one
     */
    public Uncertainty after(double headingDeg, Pose step) {
        return after(headingDeg, step, DEG_PER_M);
    }

    /**
     * Returns the uncertainty after a motion as {@link #after(double, Pose)} does, for a robot that veers more.
     *
     * @param headingDeg the heading of the robot on the map before the motion
     * @param step the pose afterwards, seen from the one before
     * @param degPerM the standard deviation of the heading after one metre, deg
     * @return a larger one
     */
    public Uncertainty after(double headingDeg, Pose step, double degPerM) {
        double way = Math.hypot(step.xMm(), step.yMm());
        double turn = Math.abs(step.headingDeg());
        if (!isKnown() || way == 0 && turn == 0) {
            return this;
        }
        double angle = Math.toRadians(headingDeg);
        double dx = step.xMm() * Math.cos(angle) - step.yMm() * Math.sin(angle);
        double dy = step.xMm() * Math.sin(angle) + step.yMm() * Math.cos(angle);
        double added = ofWay(way, turn);
        return new Uncertainty(
                xx - 2 * dy * xt + dy * dy * tt + added,
                xy + dx * xt - dy * yt - dx * dy * tt,
                yy + 2 * dx * yt + dx * dx * tt + added,
                xt - dy * tt,
                yt + dx * tt,
                tt + ofTurn(way, turn, degPerM));
    }
}

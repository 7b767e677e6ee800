package majic.nav.mapping;

import majic.bot.Pose;

/**
 * Where a scan is looked for: around a predicted pose, up to three standard deviations away.
 *
 * @param centre the predicted pose
 * @param sigmaMm the standard deviation of its place in each direction, mm
 * @param sigmaDeg the standard deviation of its heading, deg
 */
record SearchWindow(Pose centre, double sigmaMm, double sigmaDeg) {
    private static final double SIGMAS = 3;

    /** Errors of wheel odometry: 10 % of a way and of a turn, and 2 degrees a metre (Thrun, Burgard, Fox 2005, 5.4). */
    private static final double SHARE = 0.1;

    private static final double DEG_PER_MM = 0.002;
    private static final double LEAST_MM = 20;
    private static final double LEAST_DEG = 1;

    /** Where the robot is after a motion that wheel odometry has measured. */
    static SearchWindow afterMotion(Pose from, Pose moved) {
        double way = Math.hypot(moved.xMm(), moved.yMm());
        double turn = Math.abs(moved.headingDeg());
        return new SearchWindow(from.plus(moved), LEAST_MM + SHARE * way, LEAST_DEG + SHARE * turn + DEG_PER_MM * way);
    }

    double reachMm() {
        return SIGMAS * sigmaMm;
    }

    double reachDeg() {
        return Math.min(180, SIGMAS * sigmaDeg);
    }
}

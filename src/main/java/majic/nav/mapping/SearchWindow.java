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

    double reachMm() {
        return SIGMAS * sigmaMm;
    }

    double reachDeg() {
        return Math.min(180, SIGMAS * sigmaDeg);
    }
}

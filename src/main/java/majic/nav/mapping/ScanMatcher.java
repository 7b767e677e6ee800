package majic.nav.mapping;

import java.util.Optional;
import majic.bot.Pose;

/**
 * Matches a scan to the points of others: a correlative search for the best of all local maxima, then a refinement by
 * Gauss-Newton on the distances between the echoes and the lines of the surfaces (the metric of Censi 2008) with a
 * Cauchy kernel.
 */
final class ScanMatcher {
    /**
     * The standard deviation of an echo from the line of its surface: 10 to 20 mm of the sensor, and the errors of the
     * poses of the reference.
     */
    private static final double SIGMA_MM = 30;

    /** Where the Cauchy kernel halves the weight: two standard deviations. */
    private static final double KERNEL_MM = 60;

    /**
     * The weight of an echo near a point that is on no line: that point is another one of the same object, up to 200 mm
     * away, so its standard deviation is three times that of a line.
     */
    private static final double ISOLATED = 0.1;

    /**
     * The cosine between the normals of the two sides of a wall, at least 120 degrees: at a corner, the normals of one
     * side are up to 90 degrees apart.
     */
    private static final double OTHER_SIDE = -0.5;

    /** What an ideal match would still be wrong by, since surfaces are not lines and motion distorts a scan. */
    private static final Information FLOOR = Information.diagonal(10 * 10, 10 * 10, Math.pow(Math.toRadians(0.2), 2));

    private static final int MOST_ITERATIONS = 20;
    private static final double CONVERGED_MM = 0.1;
    private static final double CONVERGED_RAD = 1e-5;

    /** So little that it changes no direction of which the scan says anything. */
    private static final Information REGULAR = Information.ofSigmas(10_000, 90);

    private ScanMatcher() {}

    /**
     * Matches a scan.
     *
     * @param window where to look
     * @param prior the information of the window's centre, in the frame of the reference
     * @param least the least score of the search, 0 to 1
     * @return the match, or empty if there is none of this score
     */
    static Optional<ScanMatch> match(
            ReferenceGrid reference, EchoPoints points, SearchWindow window, Information prior, double least) {
        return CorrelativeSearch.best(reference, points, window, least)
                .flatMap(start -> refine(reference, points, start, window.centre(), prior));
    }

    /** Refines from a start that is within 200 mm and a few degrees; empty if nothing fits there. */
    static Optional<ScanMatch> refine(
            ReferenceGrid reference, EchoPoints points, Pose start, Pose predicted, Information prior) {
        double x = start.xMm();
        double y = start.yMm();
        double t = Math.toRadians(start.headingDeg());
        Normal normal = new Normal();
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            normal.of(reference, points, x, y, t);
            Information h = normal.information().plus(prior).plus(REGULAR);
            double[] p = prior.times(
                    x - predicted.xMm(),
                    y - predicted.yMm(),
                    Math.toRadians(Pose.normalised(Math.toDegrees(t) - predicted.headingDeg())));
            double[] step = h.inverse().times(-normal.gx - p[0], -normal.gy - p[1], -normal.gt - p[2]);
            if (!Double.isFinite(step[0] + step[1] + step[2])) {
                return Optional.empty();
            }
            x += step[0];
            y += step[1];
            t += step[2];
            if (Math.hypot(step[0], step[1]) < CONVERGED_MM && Math.abs(step[2]) < CONVERGED_RAD) {
                break;
            }
        }
        normal.of(reference, points, x, y, t);
        if (points.count == 0) {
            return Optional.empty();
        }
        Information covariance =
                normal.information().plus(prior).plus(REGULAR).inverse().plus(FLOOR);
        return Optional.of(
                new ScanMatch(new Pose(x, y, Math.toDegrees(t)), normal.response / points.count, covariance));
    }

    /** The normal equations of one iteration. */
    private static final class Normal {
        private double xx;
        private double xy;
        private double xt;
        private double yy;
        private double yt;
        private double tt;
        private double gx;
        private double gy;
        private double gt;
        private double response;

        void of(ReferenceGrid reference, EchoPoints points, double x, double y, double t) {
            xx = 0;
            xy = 0;
            xt = 0;
            yy = 0;
            yt = 0;
            tt = 0;
            gx = 0;
            gy = 0;
            gt = 0;
            response = 0;
            EchoPoints surfaces = reference.points();
            double cos = Math.cos(t);
            double sin = Math.sin(t);
            for (int index = 0; index < points.count; index++) {
                double dx = cos * points.x[index] - sin * points.y[index];
                double dy = sin * points.x[index] + cos * points.y[index];
                int near = reference.nearest(x + dx, y + dy);
                if (near < 0) {
                    continue;
                }
                double ex = x + dx - surfaces.x[near];
                double ey = y + dy - surfaces.y[near];
                double nx = surfaces.normalX[near];
                double ny = surfaces.normalY[near];
                if (nx == 0 && ny == 0) {
                    add(1, 0, ex, dx, dy, ISOLATED);
                    add(0, 1, ey, dx, dy, ISOLATED);
                    respond(Math.hypot(ex, ey));
                } else if (!isOtherSide(points, index, cos, sin, nx, ny)) {
                    double error = nx * ex + ny * ey;
                    add(nx, ny, error, dx, dy, 1);
                    respond(error);
                }
            }
        }

        /** Whether an echo is of the other side of a wall, which may be nearer than the reach of the reference. */
        private static boolean isOtherSide(EchoPoints points, int index, double cos, double sin, double nx, double ny) {
            double ownX = cos * points.normalX[index] - sin * points.normalY[index];
            double ownY = sin * points.normalX[index] + cos * points.normalY[index];
            return ownX * nx + ownY * ny < OTHER_SIDE;
        }

        private void respond(double error) {
            response += Math.exp(-error * error / (2 * KERNEL_MM * KERNEL_MM));
        }

        private void add(double nx, double ny, double error, double dx, double dy, double share) {
            double ratio = error / KERNEL_MM;
            double weight = share / ((1 + ratio * ratio) * SIGMA_MM * SIGMA_MM);
            double jt = ny * dx - nx * dy;
            xx += weight * nx * nx;
            xy += weight * nx * ny;
            xt += weight * nx * jt;
            yy += weight * ny * ny;
            yt += weight * ny * jt;
            tt += weight * jt * jt;
            gx += weight * nx * error;
            gy += weight * ny * error;
            gt += weight * jt * error;
        }

        Information information() {
            return new Information(xx, xy, xt, yy, yt, tt);
        }
    }
}

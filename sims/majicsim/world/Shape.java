package majicsim.world;

/**
 * A convex outline at a place of the room, with rounded corners of a radius: one vertex is a disc, two are a wall, more
 * (counter- clockwise) are a polygon. Everything that can touch is one of these, so one distance serves all pairs.
 * Immutable.
 */
final class Shape {
    final double[] xs;
    final double[] ys;
    final double roundMm;

    Shape(double[] xs, double[] ys, double roundMm) {
        this.xs = xs;
        this.ys = ys;
        this.roundMm = roundMm;
    }

    static Shape of(Segment wall) {
        return new Shape(new double[] {wall.x1(), wall.x2()}, new double[] {wall.y1(), wall.y2()}, 0);
    }

    int corners() {
        return xs.length;
    }

    int edges() {
        return xs.length < 3 ? xs.length - 1 : xs.length;
    }

    int next(int corner) {
        return corner + 1 == xs.length ? 0 : corner + 1;
    }

    Shape at(Pose pose) {
        double angle = Math.toRadians(pose.headingDeg());
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double[] worldX = new double[xs.length];
        double[] worldY = new double[xs.length];
        for (int i = 0; i < xs.length; i++) {
            worldX[i] = pose.xMm() + xs[i] * cos - ys[i] * sin;
            worldY[i] = pose.yMm() + xs[i] * sin + ys[i] * cos;
        }
        return new Shape(worldX, worldY, roundMm);
    }

    /** How far the farthest point of the outline lies from the frame's origin. */
    double reachMm() {
        double reach = 0;
        for (int i = 0; i < xs.length; i++) {
            reach = Math.max(reach, Math.hypot(xs[i], ys[i]));
        }
        return reach + roundMm;
    }

    /** The distance from a point to the nearest edge, corners not rounded. */
    double edgeDistanceMm(double x, double y) {
        double best = Double.POSITIVE_INFINITY;
        for (int i = 0; i < Math.max(1, edges()); i++) {
            double along = along(x, y, i);
            double dx = xs[i] + along * (xs[next(i)] - xs[i]) - x;
            double dy = ys[i] + along * (ys[next(i)] - ys[i]) - y;
            best = Math.min(best, dx * dx + dy * dy);
        }
        return Math.sqrt(best);
    }

    /** Where on an edge, from 0 to 1, the point nearest to (x, y) lies; a single vertex is an edge without length. */
    double along(double x, double y, int edge) {
        int end = next(edge);
        double ex = xs[end] - xs[edge];
        double ey = ys[end] - ys[edge];
        double square = ex * ex + ey * ey;
        if (square == 0) {
            return 0;
        }
        return Math.max(0, Math.min(1, ((x - xs[edge]) * ex + (y - ys[edge]) * ey) / square));
    }

    boolean contains(double x, double y) {
        if (xs.length < 3) {
            return false;
        }
        for (int i = 0; i < xs.length; i++) {
            int j = next(i);
            if ((xs[j] - xs[i]) * (y - ys[i]) - (ys[j] - ys[i]) * (x - xs[i]) < 0) {
                return false;
            }
        }
        return true;
    }
}

package majicsim.world;

import java.util.List;

/**
 * A strip of black insulating tape on the white floor: straight pieces from point to point. It is no obstacle.
 *
 * @param points at least two, mm; a closed line repeats its first one
 */
public record Tape(List<Point> points) {
    /** The width of the tape on sale. */
    public static final double WIDTH_MM = 19;

    /** A sensor detects a spot of some size, so its reading changes gradually at the edge. */
    private static final double SPOT_MM = 4;

    /**
     * Copies the points.
     *
     * @throws IllegalArgumentException if there are fewer than two
     */
    public Tape {
        points = List.copyOf(points);
        if (points.size() < 2) {
            throw new IllegalArgumentException("a tape needs two points, not " + points.size());
        }
    }

    /** How much of a small spot of floor it covers: 0 none to 1 all. */
    double coverage(Point spot) {
        double fromEdgeMm = WIDTH_MM / 2 - distanceMm(spot);
        return Math.max(0, Math.min(1, 0.5 + fromEdgeMm / SPOT_MM));
    }

    private double distanceMm(Point spot) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 1; i < points.size(); i++) {
            nearest = Math.min(nearest, distanceMm(points.get(i - 1), points.get(i), spot));
        }
        return nearest;
    }

    private static double distanceMm(Point a, Point b, Point spot) {
        double dx = b.xMm() - a.xMm();
        double dy = b.yMm() - a.yMm();
        double length2 = dx * dx + dy * dy;
        double along = length2 == 0 ? 0 : ((spot.xMm() - a.xMm()) * dx + (spot.yMm() - a.yMm()) * dy) / length2;
        double part = Math.max(0, Math.min(1, along));
        return spot.distanceTo(new Point(a.xMm() + part * dx, a.yMm() + part * dy));
    }
}

package majicsim.world;

import java.util.List;

/**
 * The upright rectangle around a room's walls.
 *
 * @param minX left edge, mm
 * @param minY lower edge, mm
 * @param maxX right edge, mm
 * @param maxY upper edge, mm
 */
public record Bounds(double minX, double minY, double maxX, double maxY) {
    /** More than a distance is rounded by: bounds of what may be hit are so much larger. */
    static final double SLACK_MM = 1;

    static Bounds around(List<Segment> walls) {
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (Segment wall : walls) {
            minX = Math.min(minX, Math.min(wall.x1(), wall.x2()));
            minY = Math.min(minY, Math.min(wall.y1(), wall.y2()));
            maxX = Math.max(maxX, Math.max(wall.x1(), wall.x2()));
            maxY = Math.max(maxY, Math.max(wall.y1(), wall.y2()));
        }
        return walls.isEmpty() ? new Bounds(-5000, -5000, 5000, 5000) : new Bounds(minX, minY, maxX, maxY);
    }

    /**
     * Whether a point lies within or on the edge.
     *
     * @param xMm mm
     * @param yMm mm
     * @return true if it does
     */
    public boolean contains(double xMm, double yMm) {
        return xMm >= minX && xMm <= maxX && yMm >= minY && yMm <= maxY;
    }
}

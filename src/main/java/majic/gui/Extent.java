package majic.gui;

import org.jspecify.annotations.Nullable;

/**
 * A rectangle of floor, mm. Immutable.
 *
 * @param minX left
 * @param minY bottom
 * @param maxX right, not less than left
 * @param maxY top, not less than bottom
 */
record Extent(double minX, double minY, double maxX, double maxY) {
    /** What an empty map shows. */
    private static final Extent DEFAULT = new Extent(-1500, -1000, 1500, 1000);

    private static final double MARGIN_MM = 200;

    /** The smallest one around everything in a scene, with some floor around robots that stand free. */
    static Extent of(MapScene scene) {
        Extent all = null;
        for (var wall : scene.walls()) {
            all = joined(all, around(wall.x1(), wall.y1(), 0));
            all = joined(all, around(wall.x2(), wall.y2(), 0));
        }
        double free = scene.walls().isEmpty() ? 2 * MARGIN_MM : 0;
        for (MapScene.Robot robot : scene.robots()) {
            all = joined(all, around(robot.believed().xMm(), robot.believed().yMm(), robot.bodyMm() + free));
            for (MapScene.Point point : robot.trail()) {
                all = joined(all, around(point.xMm(), point.yMm(), free));
            }
        }
        return all == null ? DEFAULT : all.grown();
    }

    double width() {
        return maxX - minX;
    }

    double height() {
        return maxY - minY;
    }

    private static Extent around(double x, double y, double radius) {
        return new Extent(x - radius, y - radius, x + radius, y + radius);
    }

    private static Extent joined(@Nullable Extent a, Extent b) {
        return a == null
                ? b
                : new Extent(
                        Math.min(a.minX, b.minX),
                        Math.min(a.minY, b.minY),
                        Math.max(a.maxX, b.maxX),
                        Math.max(a.maxY, b.maxY));
    }

    private Extent grown() {
        return new Extent(minX - MARGIN_MM, minY - MARGIN_MM, maxX + MARGIN_MM, maxY + MARGIN_MM);
    }
}

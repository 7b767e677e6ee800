package majic.hemisson.panel;

import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.util.List;

/**
 * Where the bar of a sensor begins on the drawing, and where the sensor looks: at its true place and in its true
 * direction (Hemisson sheet 6), moved out to the hull. The two that look at the ground lie inside, side by side.
 *
 * @param name in words
 * @param xMm ahead
 * @param yMm to the left
 * @param directionDeg counterclockwise from ahead
 * @param lengthMm of the bar
 */
record SensorDrawing(String name, double xMm, double yMm, double directionDeg, double lengthMm) {
    private static final double OUTSIDE = 38;
    private static final double INSIDE = 27;

    /** By the order of the robot's answer. */
    static final List<SensorDrawing> ALL = List.of(
            new SensorDrawing("front", 62, 0, 0, OUTSIDE),
            new SensorDrawing("front right", 50, -37, -38, OUTSIDE),
            new SensorDrawing("front left", 50, 37, 38, OUTSIDE),
            new SensorDrawing("right", 10, -62, -90, OUTSIDE),
            new SensorDrawing("left", 10, 62, 90, OUTSIDE),
            new SensorDrawing("rear", -62, 0, 180, OUTSIDE),
            new SensorDrawing("ground right", 26, -8, 0, INSIDE),
            new SensorDrawing("ground left", 26, 8, 0, INSIDE));

    boolean looksDown() {
        return lengthMm == INSIDE;
    }

    /** From the bar's own frame, along it, to the robot's. */
    AffineTransform transform() {
        AffineTransform transform = AffineTransform.getTranslateInstance(xMm, yMm);
        transform.rotate(Math.toRadians(directionDeg));
        return transform;
    }

    /** A place on the bar's axis, in the robot's frame. */
    Point2D along(double mm) {
        return transform().transform(new Point2D.Double(mm, 0), null);
    }
}

package majic.hemisson.panel;

import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.util.List;
import majic.text.Texts;

/**
 * Where the bar of a sensor begins on the drawing, and where the sensor looks: at its true place and in its true
 * direction (Hemisson sheet 6), moved out to the hull. The two that look at the ground lie inside, side by side.
 *
 * @param text key of its name
 * @param xMm ahead
 * @param yMm to the left
 * @param directionDeg counterclockwise from ahead
 * @param lengthMm of the bar
 */
record SensorDrawing(String text, double xMm, double yMm, double directionDeg, double lengthMm) {
    private static final Texts TEXTS = Texts.of(SensorDrawing.class);
    private static final double OUTSIDE = 38;
    private static final double INSIDE = 27;

    /** By the order of the robot's answer. */
    static final List<SensorDrawing> ALL = List.of(
            new SensorDrawing("front", 62, 0, 0, OUTSIDE),
            new SensorDrawing("frontRight", 50, -37, -38, OUTSIDE),
            new SensorDrawing("frontLeft", 50, 37, 38, OUTSIDE),
            new SensorDrawing("right", 10, -62, -90, OUTSIDE),
            new SensorDrawing("left", 10, 62, 90, OUTSIDE),
            new SensorDrawing("rear", -62, 0, 180, OUTSIDE),
            new SensorDrawing("groundRight", 26, -8, 0, INSIDE),
            new SensorDrawing("groundLeft", 26, 8, 0, INSIDE));

    /** Returns its name in words. */
    String words() {
        return TEXTS.get(text);
    }

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

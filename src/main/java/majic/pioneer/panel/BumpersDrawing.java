package majic.pioneer.panel;

import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import majic.panel.DrawingColors;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Hull;
import majic.pioneer.state.PioneerState;

/**
 * The segments of a robot's bumpers around its hull: thin while they are free, thick where they are touched. They are
 * counted clockwise: segment 1 is the leftmost in front and the rightmost at the rear.
 */
final class BumpersDrawing {
    /** How much of the hull's round the segments of one end cover together. */
    private static final double RANGE_DEG = 135;

    private static final double GAP_DEG = 4;
    private static final double OFF_MM = 35;

    private final Hull hull;
    private final DrawingColors colors;
    private final double pxPerMm;

    BumpersDrawing(Hull hull, DrawingColors colors, double pxPerMm) {
        this.hull = hull;
        this.colors = colors;
        this.pxPerMm = pxPerMm;
    }

    /** Paints in the robot's frame, mm. */
    void paint(Graphics2D pen, Bumpers bumpers, PioneerState state) {
        paintEnd(pen, hull.frontMm() + OFF_MM, 0, bumpers.frontSegments(), bumpers.front(state));
        paintEnd(pen, hull.rearMm() + OFF_MM, 180, bumpers.rearSegments(), bumpers.rear(state));
    }

    private void paintEnd(Graphics2D pen, double lengthMm, double directionDeg, int segments, int touched) {
        double width = RANGE_DEG / Math.max(1, segments);
        for (int segment = 0; segment < segments; segment++) {
            double left = directionDeg + RANGE_DEG / 2 - segment * width;
            paintSegment(pen, lengthMm, left - GAP_DEG / 2, width - GAP_DEG, (touched & 1 << segment) != 0);
        }
    }

    /** Arc2D counts angles clockwise in these axes. */
    private void paintSegment(Graphics2D pen, double lengthMm, double leftDeg, double widthDeg, boolean touched) {
        double half = hull.halfWidthMm() + OFF_MM;
        pen.setColor(touched ? colors.alarm() : colors.grey(0.7));
        pen.setStroke(DrawingColors.stroke((touched ? 6 : 2) / pxPerMm));
        pen.draw(new Arc2D.Double(-lengthMm, -half, 2 * lengthMm, 2 * half, -leftDeg, widthDeg, Arc2D.OPEN));
    }
}

package majic.pioneer.panel;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import majic.panel.DrawingColors;
import majic.pioneer.state.Hull;
import majic.pioneer.state.SonarDisc;

/**
 * The robot itself in its own frame, mm: hull, bumpers, wheels, an arrow ahead; wheels are crossed where they are
 * stalled. In a map at a small scale only the arrow is drawn, large enough to be found.
 */
final class PioneerBodyDrawing {
    private static final double CORNER = 0.3;
    private static final double WHEEL_WIDTH_MM = 50;
    private static final double WHEEL_LENGTH_MM = 190;
    private static final double DISC_MM = 16;

    /** A hull narrower than this shows no parts. */
    private static final double LEAST_PX = 14;

    private static final double ARROW_PX = 11;

    private final PioneerScene scene;
    private final Hull hull;
    private final DrawingColors colors;
    private final double pxPerMm;

    PioneerBodyDrawing(PioneerScene scene, DrawingColors colors, double pxPerMm) {
        this.scene = scene;
        this.hull = scene.model().hull();
        this.colors = colors;
        this.pxPerMm = pxPerMm;
    }

    void paint(Graphics2D pen) {
        if (2 * hull.halfWidthMm() * pxPerMm < LEAST_PX) {
            pen.setColor(colors.line());
            pen.fill(arrow(ARROW_PX / pxPerMm));
            return;
        }
        part(pen, outline(), 0.15);
        paintWheel(pen, hull.halfWidthMm(), scene.state().stallLeft());
        paintWheel(pen, -hull.halfWidthMm(), scene.state().stallRight());
        paintDiscs(pen);
        pen.setColor(colors.line());
        pen.fill(arrow(0.6 * hull.frontMm()));
        new BumpersDrawing(hull, colors, pxPerMm).paint(pen, scene.bumpers(), scene.state());
    }

    /** A box with its corners cut off. */
    private Shape outline() {
        double half = hull.halfWidthMm();
        double cut = CORNER * half;
        Path2D outline = new Path2D.Double();
        outline.moveTo(hull.frontMm(), half - 2 * cut);
        outline.lineTo(hull.frontMm() - cut, half);
        outline.lineTo(cut - hull.rearMm(), half);
        outline.lineTo(-hull.rearMm(), half - 2 * cut);
        outline.lineTo(-hull.rearMm(), 2 * cut - half);
        outline.lineTo(cut - hull.rearMm(), -half);
        outline.lineTo(hull.frontMm() - cut, -half);
        outline.lineTo(hull.frontMm(), 2 * cut - half);
        outline.closePath();
        return outline;
    }

    private void paintWheel(Graphics2D pen, double sideMm, boolean stalled) {
        double y = sideMm > 0 ? sideMm - WHEEL_WIDTH_MM : sideMm;
        double half = Math.min(WHEEL_LENGTH_MM, hull.frontMm() + hull.rearMm()) / 2;
        part(pen, new RoundRectangle2D.Double(-half, y, 2 * half, WHEEL_WIDTH_MM, 30, 30), 0.6);
        if (stalled) {
            pen.setColor(colors.alarm());
            pen.setStroke(DrawingColors.stroke(3 / pxPerMm));
            pen.draw(new Line2D.Double(-half, y, half, y + WHEEL_WIDTH_MM));
            pen.draw(new Line2D.Double(-half, y + WHEEL_WIDTH_MM, half, y));
        }
    }

    private void paintDiscs(Graphics2D pen) {
        pen.setColor(colors.grey(0.6));
        for (SonarDisc disc : scene.model().discs()) {
            pen.fill(new Ellipse2D.Double(disc.xMm() - DISC_MM, disc.yMm() - DISC_MM, 2 * DISC_MM, 2 * DISC_MM));
        }
    }

    private static Shape arrow(double length) {
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(length, 0);
        arrow.lineTo(-0.2 * length, 0.45 * length);
        arrow.lineTo(0.1 * length, 0);
        arrow.lineTo(-0.2 * length, -0.45 * length);
        arrow.closePath();
        return arrow;
    }

    private void part(Graphics2D pen, Shape shape, double grey) {
        pen.setColor(colors.grey(grey));
        pen.fill(shape);
        pen.setColor(colors.grey(0.85));
        pen.setStroke(DrawingColors.stroke(1.3 / pxPerMm));
        pen.draw(shape);
    }
}

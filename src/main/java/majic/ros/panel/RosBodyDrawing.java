package majic.ros.panel;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import majic.panel.DrawingColors;

/**
 * The robot itself in its own frame, mm: a disc of its size with an arrow ahead; the disc is outlined in the alarm colour
 * while it touches something. In a map at a small scale only the arrow is drawn, large enough to be found.
 */
final class RosBodyDrawing {
    /** A hull narrower than this shows no parts. */
    private static final double LEAST_PX = 14;

    private static final double ARROW_PX = 11;

    private final RosScene scene;
    private final DrawingColors colors;
    private final double pxPerMm;

    RosBodyDrawing(RosScene scene, DrawingColors colors, double pxPerMm) {
        this.scene = scene;
        this.colors = colors;
        this.pxPerMm = pxPerMm;
    }

    void paint(Graphics2D pen) {
        double radius = scene.robot().radiusMm();
        if (2 * radius * pxPerMm < LEAST_PX) {
            pen.setColor(colors.line());
            pen.fill(arrow(ARROW_PX / pxPerMm));
            return;
        }
        boolean touches = !scene.contacts().isEmpty() && scene.isConnected();
        Shape hull = new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius);
        pen.setColor(colors.grey(0.15));
        pen.fill(hull);
        pen.setColor(touches ? colors.alarm() : colors.grey(0.85));
        pen.setStroke(DrawingColors.stroke((touches ? 4 : 1.3) / pxPerMm));
        pen.draw(hull);
        pen.setColor(colors.line());
        pen.fill(arrow(0.6 * radius));
    }

    private static Shape arrow(double length) {
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(length, 0);
        arrow.lineTo(-0.5 * length, 0.6 * length);
        arrow.lineTo(-0.2 * length, 0);
        arrow.lineTo(-0.5 * length, -0.6 * length);
        arrow.closePath();
        return arrow;
    }
}

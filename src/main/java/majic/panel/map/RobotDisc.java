package majic.panel.map;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import majic.panel.DrawingColors;

/**
 * A robot in its own frame, mm: a disc of its size with an arrow ahead; the disc is outlined in the alarm colour while
 * it touches something. In a map at a small scale only the arrow is drawn, large enough to be found. Immutable.
 *
 * @param radiusMm above 0
 * @param touches whether it touches something
 */
public record RobotDisc(double radiusMm, boolean touches) {
    /** A narrower disc shows no parts. */
    private static final double LEAST_PX = 14;

    private static final double ARROW_PX = 11;

    /**
     * Paints it. For the event dispatch thread.
     *
     * @param pen in the frame of the robot, mm
     * @param colors those of a robot that reports, or faded ones
     * @param pxPerMm the scale of the map
     */
    public void paint(Graphics2D pen, DrawingColors colors, double pxPerMm) {
        if (2 * radiusMm * pxPerMm < LEAST_PX) {
            pen.setColor(colors.line());
            pen.fill(arrow(ARROW_PX / pxPerMm));
            return;
        }
        Shape hull = new Ellipse2D.Double(-radiusMm, -radiusMm, 2 * radiusMm, 2 * radiusMm);
        pen.setColor(colors.grey(0.15));
        pen.fill(hull);
        pen.setColor(touches ? colors.alarm() : colors.grey(0.85));
        pen.setStroke(DrawingColors.stroke((touches ? 4 : 1.3) / pxPerMm));
        pen.draw(hull);
        pen.setColor(colors.line());
        pen.fill(arrow(0.6 * radiusMm));
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

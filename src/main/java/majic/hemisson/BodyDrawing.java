package majic.hemisson;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import majic.panel.Ink;

/**
 * The robot without its sensors: a round body; wheels with an arrow that grows with what the motor is told; lamps that
 * shine when on; and at the rear the four switches.
 */
final class BodyDrawing {
    private static final double HULL_MM = Clearance.HULL_MM;
    private static final double WHEEL_Y_MM = 46;
    private static final double ARROW_MM = 17;

    private final HemissonView view;
    private final Ink ink;
    private final double pxPerMm;

    BodyDrawing(HemissonView view, Ink ink, double pxPerMm) {
        this.view = view;
        this.ink = ink;
        this.pxPerMm = pxPerMm;
    }

    /** Paints around the pen's origin, ahead upward. */
    void paint(Graphics2D screen) {
        Graphics2D pen = (Graphics2D) screen.create();
        pen.transform(new AffineTransform(0, -pxPerMm, -pxPerMm, 0, 0, 0));
        part(pen, circle(0, 0, HULL_MM), 0.13);
        paintWheel(pen, WHEEL_Y_MM, view.wheels().left());
        paintWheel(pen, -WHEEL_Y_MM, view.wheels().right());
        paintLamp(pen, 40, 24, view.leds().left());
        paintLamp(pen, 40, -24, view.leds().right());
        paintLamp(pen, -14, -24, view.leds().pgm());
        paintSwitches(pen, view.switches());
        pen.dispose();
        paintFigure(screen, WHEEL_Y_MM, view.wheels().left());
        paintFigure(screen, -WHEEL_Y_MM, view.wheels().right());
    }

    private void paintWheel(Graphics2D pen, double y, int told) {
        part(pen, new RoundRectangle2D.Double(-22, y - 8, 44, 16, 8, 8), 0.3);
        if (told != 0) {
            double tip = ARROW_MM * told / Wheels.MAX;
            Path2D arrow = new Path2D.Double();
            arrow.moveTo(tip + Math.signum(tip) * 4, y);
            arrow.lineTo(0, y - 7);
            arrow.lineTo(0, y + 7);
            arrow.closePath();
            pen.setColor(ink.line());
            pen.fill(arrow);
        }
    }

    /** What the motor is told, below its wheel. */
    private void paintFigure(Graphics2D screen, double y, int told) {
        String text = String.valueOf(told);
        FontMetrics metrics = screen.getFontMetrics();
        screen.setColor(ink.line());
        screen.drawString(text, (float) (-y * 0.8 * pxPerMm - metrics.stringWidth(text) / 2.0), (float)
                (28 * pxPerMm + metrics.getAscent() * 0.6));
    }

    /** A lamp that is on is filled and has a ring of light. */
    private void paintLamp(Graphics2D pen, double x, double y, boolean on) {
        if (on) {
            pen.setColor(ink.wash(0.3));
            pen.fill(circle(x, y, 10));
            pen.setColor(ink.accent());
            pen.fill(circle(x, y, 5));
        }
        outline(pen, circle(x, y, 5));
    }

    /** Sliders in the order the robot lists them; one that reads 1 is at the upper end. */
    private void paintSwitches(Graphics2D pen, List<Integer> switches) {
        for (int index = 0; index < switches.size(); index++) {
            double y = 13.5 - 9 * index;
            part(pen, new Rectangle2D.Double(-52, y - 3, 16, 6), 0);
            pen.setColor(ink.line());
            pen.fill(new Rectangle2D.Double(switches.get(index) == 1 ? -44 : -52, y - 3, 8, 6));
        }
    }

    private void part(Graphics2D pen, Shape shape, double grey) {
        pen.setColor(ink.grey(grey));
        pen.fill(shape);
        outline(pen, shape);
    }

    private void outline(Graphics2D pen, Shape shape) {
        pen.setColor(ink.grey(0.8));
        pen.setStroke(Ink.stroke(1.3 / pxPerMm));
        pen.draw(shape);
    }

    private static Ellipse2D circle(double x, double y, double radius) {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }
}

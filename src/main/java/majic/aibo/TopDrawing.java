package majic.aibo;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import majic.panel.Ink;

/** The dog seen from above, in mm around the point where its head turns: ahead is y, its right is x. */
final class TopDrawing {
    /** From where the head turns to the nose. */
    static final double NOSE_MM = 98;

    /** From where the head turns to the tip of the tail. */
    static final double BEHIND_HEAD_MM = 320;

    /** With a little room beside the paws. */
    static final double HALF_WIDTH_MM = 110;

    private static final double OUTLINE_MM = 4;

    private final Senses senses;
    private final Ink ink;

    TopDrawing(Senses senses, Ink ink) {
        this.senses = senses;
        this.ink = ink;
    }

    void paint(Graphics2D pen) {
        paintTail(pen);
        paintLeg(pen, -1, -70, Sensor.PAW_LF);
        paintLeg(pen, 1, -70, Sensor.PAW_RF);
        paintLeg(pen, -1, -235, Sensor.PAW_LH);
        paintLeg(pen, 1, -235, Sensor.PAW_RH);
        part(pen, body(), 0.14);
        part(pen, new RoundRectangle2D.Double(-22, -205, 44, 120, 40, 40), 0.24);
        Graphics2D head = (Graphics2D) pen.create();
        head.rotate(Math.toRadians(senses.number(Sensor.HEAD_PAN).orElse(0.0)));
        paintHead(head);
        head.dispose();
    }

    private void paintTail(Graphics2D pen) {
        Path2D tail = new Path2D.Double();
        tail.moveTo(0, -255);
        tail.curveTo(0, -285, 18, -285, 14, -310);
        pen.setColor(ink.grey(0.6));
        pen.setStroke(Ink.stroke(12));
        pen.draw(tail);
    }

    /** A leg with its paw, which is filled while it stands on the ground. */
    private void paintLeg(Graphics2D pen, int side, double y, Sensor paw) {
        part(pen, new RoundRectangle2D.Double(side * 72 - 20, y - 35, 40, 78, 36, 36), 0.24);
        boolean down = senses.number(paw).orElse(0.0) > 0;
        part(pen, ellipse(side * 74, y + 40, 20, 17), down ? 0.65 : 0);
    }

    private static Area body() {
        Area body = new Area(ellipse(0, -65, 62, 62));
        body.add(new Area(ellipse(0, -210, 60, 58)));
        body.add(new Area(new RoundRectangle2D.Double(-50, -225, 100, 175, 40, 40)));
        return body;
    }

    private void paintHead(Graphics2D pen) {
        part(pen, ellipse(0, -4, 28, 30), 0.4);
        part(pen, ellipse(0, 26, 44, 42), 0.1);
        part(pen, ellipse(0, 66, 27, 30), 0.1);
        part(pen, ear(1), 0.5);
        part(pen, ear(-1), 0.5);
        pen.setColor(ink.line());
        pen.fill(ellipse(0, 90, 11, 7));
        pen.fill(ellipse(-16, 50, 5, 6));
        pen.fill(ellipse(16, 50, 5, 6));
    }

    private static Shape ear(int side) {
        AffineTransform hanging = AffineTransform.getTranslateInstance(side * 42, 14);
        hanging.rotate(side * Math.toRadians(14));
        return hanging.createTransformedShape(ellipse(0, 0, 13, 32));
    }

    private void part(Graphics2D pen, Shape shape, double grey) {
        pen.setColor(ink.grey(grey));
        pen.fill(shape);
        pen.setColor(ink.grey(0.8));
        pen.setStroke(Ink.stroke(OUTLINE_MM));
        pen.draw(shape);
    }

    private static Ellipse2D ellipse(double x, double y, double halfWidth, double halfHeight) {
        return new Ellipse2D.Double(x - halfWidth, y - halfHeight, 2 * halfWidth, 2 * halfHeight);
    }
}

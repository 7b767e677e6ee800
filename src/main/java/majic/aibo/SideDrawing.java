package majic.aibo;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.RoundRectangle2D;
import majic.panel.Ink;

/** The dog seen from its right, looking to the right: mm, x ahead, y up from the ground. Tells neck, head and posture. */
final class SideDrawing {
    /** From the tip of the tail to the nose when the neck is bowed. */
    static final double LENGTH_MM = 455;

    /** With the head as high as it gets. */
    static final double HEIGHT_MM = 335;

    /** From the origin back to the tip of the tail. */
    static final double TAIL_MM = 180;

    private static final double BODY_MM = 170;
    private static final double NECK_MM = 55;
    private static final double OUTLINE_MM = 5;

    private final Senses senses;
    private final Ink ink;
    private final Stance stance;

    SideDrawing(Senses senses, Ink ink) {
        this.senses = senses;
        this.ink = ink;
        this.stance = Stance.of(senses.posture());
    }

    void paint(Graphics2D pen) {
        pen.setColor(ink.grey(0.35));
        pen.setStroke(Ink.stroke(3));
        pen.draw(new Line2D.Double(-TAIL_MM, 0, LENGTH_MM - TAIL_MM, 0));
        Graphics2D trunk = (Graphics2D) pen.create();
        trunk.translate(stance.hipMm(), stance.hipHeightMm());
        trunk.rotate(Math.toRadians(stance.pitchDeg()));
        paintTrunk(trunk);
        trunk.dispose();
        double pitch = Math.toRadians(stance.pitchDeg());
        double shoulderX = stance.hipMm() + BODY_MM * Math.cos(pitch);
        double shoulderY = stance.hipHeightMm() + BODY_MM * Math.sin(pitch);
        paintLeg(pen, new Point2D.Double(shoulderX, shoulderY), stance.forePawMm(), -22);
        paintLeg(pen, new Point2D.Double(stance.hipMm(), stance.hipHeightMm()), stance.hindPawMm(), 28);
    }

    /** Body, tail and head, from the hip along the back. */
    private void paintTrunk(Graphics2D pen) {
        Path2D tail = new Path2D.Double();
        tail.moveTo(-32, 25);
        tail.curveTo(-70, 35, -60, 75, -78, 105);
        pen.setColor(ink.grey(0.6));
        pen.setStroke(Ink.stroke(13));
        pen.draw(tail);
        Graphics2D head = (Graphics2D) pen.create();
        head.translate(BODY_MM + 12, 35);
        paintNeckAndHead(head);
        head.dispose();
        part(pen, new RoundRectangle2D.Double(-42, -38, BODY_MM + 84, 88, 80, 80), 0.14);
    }

    /** The head sits on the neck and turns with it. */
    private void paintNeckAndHead(Graphics2D pen) {
        pen.rotate(Math.toRadians(senses.number(Sensor.NECK).orElse(0.0)));
        pen.setColor(ink.grey(0.5));
        pen.setStroke(Ink.stroke(34));
        pen.draw(new Line2D.Double(0, 0, 0, NECK_MM));
        pen.translate(0, NECK_MM + 10);
        pen.rotate(Math.toRadians(senses.number(Sensor.HEAD_TILT).orElse(0.0)));
        part(pen, new RoundRectangle2D.Double(10, -30, 78, 48, 44, 44), 0.1);
        part(pen, ellipse(8, 4, 46, 40), 0.1);
        part(pen, ellipse(-12, -6, 16, 36), 0.5);
        pen.setColor(ink.line());
        pen.fill(ellipse(84, 4, 9, 9));
        pen.fill(ellipse(32, 16, 6, 7));
    }

    private void paintLeg(Graphics2D pen, Point2D joint, double pawX, double kneeX) {
        Path2D leg = new Path2D.Double();
        leg.moveTo(joint.getX(), joint.getY());
        leg.lineTo((joint.getX() + pawX) / 2 + kneeX, joint.getY() / 2 + 8);
        leg.lineTo(pawX, 16);
        pen.setColor(ink.grey(0.8));
        pen.setStroke(Ink.stroke(38));
        pen.draw(leg);
        pen.setColor(ink.grey(0.3));
        pen.setStroke(Ink.stroke(38 - 2 * OUTLINE_MM));
        pen.draw(leg);
        part(pen, new RoundRectangle2D.Double(pawX - 20, 0, 52, 28, 26, 26), 0.3);
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

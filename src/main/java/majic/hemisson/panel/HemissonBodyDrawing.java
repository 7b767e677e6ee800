package majic.hemisson.panel;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import majic.hemisson.line.MotorValues;
import majic.hemisson.readings.Clearance;
import majic.panel.DrawingColors;

/**
 * The robot without its sensors and LEDs: a round body, flat at the sides; wheels filled in proportion to the values of
 * their motors, with an arrow; and at the rear the four switches. In the robot's frame, mm.
 */
final class HemissonBodyDrawing {
    static final double WHEEL_Y_MM = 47;
    static final double WHEEL_HALF_MM = 22;

    private static final double HULL_MM = Clearance.HULL_MM;
    private static final double WHEEL_HALF_WIDTH_MM = 7;
    private static final double ARROW_MM = 6;
    /** Least distance of a text from the outline. */
    private static final double APART_MM = 3;

    private final HemissonScene view;
    private final DrawingColors colors;
    private final double pxPerMm;

    HemissonBodyDrawing(HemissonScene view, DrawingColors colors, double pxPerMm) {
        this.view = view;
        this.colors = colors;
        this.pxPerMm = pxPerMm;
    }

    /**
     * Returns the place of a text beside or below the centre line, moved towards that line if it would touch the
     * outline.
     *
     * @param centre the wanted centre of the text, pixels to the left
     * @param width the width of the text, pixels
     * @param foot how far its foot is behind the centre of the robot, pixels
     */
    static double insideHull(double centre, double width, double foot, double pxPerMm) {
        double radius = (HULL_MM - APART_MM) * pxPerMm;
        double most = Math.sqrt(Math.max(0, radius * radius - foot * foot)) - width / 2;
        return Math.copySign(Math.min(Math.abs(centre), Math.max(0, most)), centre);
    }

    void paint(Graphics2D pen) {
        part(pen, new Ellipse2D.Double(-HULL_MM, -HULL_MM, 2 * HULL_MM, 2 * HULL_MM), 0.12);
        paintNose(pen);
        paintWheel(pen, WHEEL_Y_MM, view.wheels().left());
        paintWheel(pen, -WHEEL_Y_MM, view.wheels().right());
        paintSwitches(pen, view.switches());
    }

    /** A mark for ahead. */
    private void paintNose(Graphics2D pen) {
        Path2D nose = new Path2D.Double();
        nose.moveTo(HULL_MM - 1, 0);
        nose.lineTo(HULL_MM - 8, 8);
        nose.lineTo(HULL_MM - 8, -8);
        nose.closePath();
        pen.setColor(colors.grey(0.55));
        pen.fill(nose);
    }

    private void paintWheel(Graphics2D pen, double y, int value) {
        Shape tyre = new RoundRectangle2D.Double(
                -WHEEL_HALF_MM, y - WHEEL_HALF_WIDTH_MM, 2 * WHEEL_HALF_MM, 2 * WHEEL_HALF_WIDTH_MM, 6, 6);
        part(pen, tyre, 0.28);
        if (value == 0) {
            return;
        }
        double tip = WHEEL_HALF_MM * value / MotorValues.MAX;
        double side = WHEEL_HALF_WIDTH_MM - 2;
        pen.setColor(colors.accent());
        pen.fill(new Rectangle2D.Double(Math.min(0, tip), y - side, Math.abs(tip), 2 * side));
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(tip + Math.signum(tip) * ARROW_MM, y);
        arrow.lineTo(tip, y + side);
        arrow.lineTo(tip, y - side);
        arrow.closePath();
        pen.fill(arrow);
        pen.setColor(colors.grey(0.85));
        pen.setStroke(DrawingColors.stroke(1.3 / pxPerMm));
        pen.draw(tyre);
    }

    /** Sliders in the order the robot lists them; one that reads 1 is at the upper end. */
    private void paintSwitches(Graphics2D pen, List<Integer> switches) {
        for (int index = 0; index < switches.size(); index++) {
            boolean one = switches.get(index) == 1;
            double y = 15 - 10 * index;
            part(pen, new Rectangle2D.Double(-54, y - 3.5, 17, 7), 0);
            pen.setColor(one ? colors.line() : colors.alarm());
            pen.fill(new Rectangle2D.Double(one ? -45.5 : -54, y - 3.5, 8.5, 7));
        }
    }

    private void part(Graphics2D pen, Shape shape, double grey) {
        pen.setColor(colors.grey(grey));
        pen.fill(shape);
        pen.setColor(colors.grey(0.8));
        pen.setStroke(DrawingColors.stroke(1.3 / pxPerMm));
        pen.draw(shape);
    }
}

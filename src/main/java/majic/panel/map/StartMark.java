package majic.panel.map;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.text.Texts;

/**
 * Marks the start of a robot's trail by a ring with a label below it; below the robot while that covers the label. The
 * label is left out where the robot or the edge of the map would cut it. Immutable.
 *
 * @param view from the floor to the pixels
 * @param robot where the robot is on the floor
 * @param radiusPx the radius of the robot as it is drawn
 */
public record StartMark(MapView view, Pose robot, double radiusPx) {
    private static final Texts TEXTS = Texts.of(StartMark.class);
    private static final double RING_PX = 5;

    /**
     * Paints the mark. For the event dispatch thread.
     *
     * @param pen in pixels
     * @param colors the colours to use
     */
    public void paint(Graphics2D pen, DrawingColors colors) {
        Point2D start = view.pixel(0, 0);
        pen.setColor(colors.faint());
        pen.setStroke(DrawingColors.stroke(1.5));
        pen.draw(circle(start, RING_PX));
        pen.fill(circle(start, 1.5));
        String text = TEXTS.get("start");
        FontMetrics metrics = pen.getFontMetrics();
        label(metrics.stringWidth(text), metrics.getHeight())
                .ifPresent(place ->
                        pen.drawString(text, (float) place.getX(), (float) place.getY() + metrics.getAscent()));
    }

    /**
     * Returns where the label is written.
     *
     * @param width of the label, pixels
     * @param height of the label, pixels
     * @return inside the map and beside the robot; empty if there is no such place
     */
    Optional<Rectangle2D> label(double width, double height) {
        Point2D start = view.pixel(0, 0);
        Point2D middle = view.pixel(robot.xMm(), robot.yMm());
        double left = start.getX() - width / 2;
        return Stream.of(start.getY() + RING_PX, middle.getY() + radiusPx + 1)
                .map(top -> (Rectangle2D) new Rectangle2D.Double(left, top, width, height))
                .filter(place -> !circle(middle, radiusPx).intersects(place))
                .filter(place -> place.getY() - start.getY() <= RING_PX + 2 * radiusPx)
                .filter(place -> new Rectangle(view.width(), view.height()).contains(place))
                .findFirst();
    }

    private static Ellipse2D circle(Point2D middle, double radius) {
        return new Ellipse2D.Double(middle.getX() - radius, middle.getY() - radius, 2 * radius, 2 * radius);
    }
}

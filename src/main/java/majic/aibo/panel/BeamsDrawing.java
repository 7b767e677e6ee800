package majic.aibo.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.bot.Value;
import majic.panel.DrawingColors;

/**
 * What the distance sensors see, around the point where the head turns: rings at every half metre, the head's beam
 * where it looks, the chest's straight ahead, and a bar at what is nearest in the way. The dog is drawn larger than the
 * rings are, so distances count from its nose on.
 */
final class BeamsDrawing {
    private static final int FARTHEST_MM = 1500;
    private static final int RING_MM = 500;
    private static final double HALF_BEAM_DEG = 3;
    private static final double HALF_BAR_DEG = 18;
    private static final double NEAR_MM = 250;

    /** How much the background of a label covers the dog. */
    private static final double LABEL_COVER = 0.8;

    private static final int MARGIN = 2;
    private static final double HIT_PX = 6;

    /** How far the paws of a lying dog are ahead of where the head turns, as a multiple of the nose's distance. */
    private static final double PAWS_AHEAD = 1.3;

    /** In drawings that are smaller than this many lines of text the rings' numbers would cover the dog. */
    private static final double LEAST_REACH_LINES = 5;

    private final DogState dog;
    private final DrawingColors colors;
    private final double reachPx;
    private final double nosePx;

    /**
     * The beams.
     *
     * @param reachPx from where the head turns to where the farthest sensor ends
     * @param nosePx from where the head turns to its nose
     */
    BeamsDrawing(DogState dog, DrawingColors colors, double reachPx, double nosePx) {
        this.dog = dog;
        this.colors = colors;
        this.reachPx = reachPx;
        this.nosePx = nosePx;
    }

    /** Paints around the pen's origin, ahead upward. */
    void paint(Graphics2D pen) {
        paintRings(pen);
        double pan = dog.senses().number(Sensor.HEAD_PAN).orElse(0.0);
        Optional<Double> seen = dog.infraRed().headMm();
        paintBeam(pen, pan, seen.orElse((double) FARTHEST_MM), seen.isPresent());
        dog.frontMm().ifPresent(mm -> paintBar(pen, mm));
        dog.infraRed().chestMm().ifPresent(mm -> paintChest(pen, mm));
        seen.ifPresent(mm -> paintHit(pen, pan, mm));
    }

    /**
     * Writes the distance that the head measures, beside the dog.
     *
     * @param roomPx how far the room extends to each side
     */
    void paintLabel(Graphics2D pen, double roomPx) {
        double pan = dog.senses().number(Sensor.HEAD_PAN).orElse(0.0);
        FontMetrics metrics = pen.getFontMetrics();
        dog.infraRed().headMm().ifPresent(mm -> {
            String text = Math.round(mm) + " mm";
            double width = metrics.stringWidth(text) + 2.0 * MARGIN;
            label(pen, text, labelAt(hit(pan, mm), width, metrics.getHeight(), roomPx));
        });
    }

    private Point2D hit(double panDeg, double mm) {
        double angle = Math.toRadians(panDeg);
        return new Point2D.Double(-radius(mm) * Math.sin(angle), -radius(mm) * Math.cos(angle));
    }

    private double radius(double mm) {
        return nosePx + (reachPx - nosePx) * Math.min(mm, FARTHEST_MM) / FARTHEST_MM;
    }

    private void paintRings(Graphics2D pen) {
        pen.setStroke(DrawingColors.stroke(1));
        double free = Double.POSITIVE_INFINITY;
        for (int mm = FARTHEST_MM; mm > 0; mm -= RING_MM) {
            pen.setColor(colors.grey(0.25));
            pen.draw(arc(radius(mm), 0, 90, Arc2D.OPEN));
            if (reachPx >= LEAST_REACH_LINES * pen.getFontMetrics().getHeight()) {
                free = paintNumber(pen, Value.plain(mm / 1000.0) + (mm == FARTHEST_MM ? " m" : ""), radius(mm), free);
            }
        }
    }

    /** Writes under the right end of a ring, if there is room to the left of what stands there already. */
    private double paintNumber(Graphics2D pen, String text, double radius, double free) {
        FontMetrics metrics = pen.getFontMetrics();
        double width = metrics.stringWidth(text);
        double left = Math.min(radius - width / 2, reachPx - width);
        if (left + width > free) {
            return free;
        }
        pen.setColor(colors.faint());
        pen.drawString(text, (float) left, metrics.getAscent() + 2f);
        return left - metrics.charWidth(' ');
    }

    private void paintBeam(Graphics2D pen, double panDeg, double mm, boolean met) {
        double radius = radius(mm);
        pen.setColor(met ? colors.wash(0.35) : colors.grey(0.15));
        pen.fill(arc(radius, panDeg, HALF_BEAM_DEG, Arc2D.PIE));
    }

    private void paintHit(Graphics2D pen, double panDeg, double mm) {
        Point2D hit = hit(panDeg, mm);
        double half = 4;
        pen.setColor(colors.accent());
        pen.fill(new Ellipse2D.Double(hit.getX() - half, hit.getY() - half, 2 * half, 2 * half));
    }

    private void paintChest(Graphics2D pen, double mm) {
        double y = -radius(mm);
        pen.setColor(colors.accent());
        pen.setStroke(new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {4, 3}, 0));
        pen.draw(new Line2D.Double(0, 0, 0, y));
        pen.setStroke(DrawingColors.stroke(1.5));
        pen.draw(new Rectangle2D.Double(-4, y - 4, 8, 8));
    }

    /** What is nearest in the way, from the foremost part of the dog. */
    private void paintBar(Graphics2D pen, double mm) {
        Color color = mm < NEAR_MM ? colors.alarm() : colors.grey(0.7);
        pen.setColor(color);
        pen.setStroke(DrawingColors.stroke(mm < NEAR_MM ? 4 : 2));
        pen.draw(arc(radius(mm), 0, HALF_BAR_DEG, Arc2D.OPEN));
    }

    /** Writes on a margin of the paper's colour. */
    private void label(Graphics2D pen, String text, Rectangle2D place) {
        pen.setColor(DrawingColors.translucent(colors.paper(), LABEL_COVER));
        pen.fill(place);
        pen.setColor(colors.line());
        pen.drawString(
                text,
                (float) place.getX() + MARGIN,
                (float) place.getY() + pen.getFontMetrics().getAscent());
    }

    /**
     * Returns the place of a label: beside a hit, away from the head; above the hit at the edge of the room where there
     * is no room beside it; above the dog where it would cover the dog.
     *
     * @param hit from where the head turns, y down
     * @param roomPx how far the room extends to each side
     */
    Rectangle2D labelAt(Point2D hit, double width, double height, double roomPx) {
        double beside = hit.getX() >= 0 ? hit.getX() + HIT_PX : hit.getX() - HIT_PX - width;
        double left = Math.max(-roomPx, Math.min(beside, roomPx - width));
        double top = left == beside ? hit.getY() - height / 2 : hit.getY() - HIT_PX - height;
        Rectangle2D place = new Rectangle2D.Double(left, Math.max(top, -reachPx), width, height);
        if (place.intersects(dogPlace())) {
            place.setRect(left, Math.max(dogPlace().getY() - height, -reachPx), width, height);
        }
        return place;
    }

    /** Returns what the dog covers at most, as far as the beams reach. */
    private Rectangle2D dogPlace() {
        double ahead = PAWS_AHEAD * nosePx;
        return new Rectangle2D.Double(-nosePx, -ahead, 2 * nosePx, ahead + reachPx);
    }

    /** Around the origin; the middle counts from ahead, counterclockwise. */
    private static Arc2D arc(double radius, double middleDeg, double halfDeg, int kind) {
        return new Arc2D.Double(-radius, -radius, 2 * radius, 2 * radius, 90 + middleDeg - halfDeg, 2 * halfDeg, kind);
    }
}

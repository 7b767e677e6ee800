package majic.gui.map;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.gui.kit.LineArt;
import majic.gui.kit.NumberBadge;
import majic.gui.kit.Palette;
import majic.gui.kit.RobotColors;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.text.Texts;

/** Draws one robot of the map: its trail, its way, its estimated pose, its true pose. */
final class RobotGlyph {
    private static final Texts TEXTS = Texts.of(RobotGlyph.class);
    /** Minimum size of a drawn body in pixels, so that a Hemisson can be found in a large room. */
    private static final double SMALLEST_PX = 8;

    private static final double TRAIL_STEP_PX = 2;
    private static final double TRAIL_OPACITY = 0.5;
    private static final double RESERVED_OPACITY = 0.3;
    private static final double PLACE_PX = 5;

    /** The root of the 95 % quantile of a chi-squared distribution of two degrees of freedom. */
    private static final double SIGMAS_OF_95 = 2.45;

    private static final Stroke TRAIL = new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final Stroke ALARM = new BasicStroke(2.5f);
    private static final double ALARM_GAP_PX = 6;
    private static final Stroke SELECTED = new BasicStroke(2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final double SELECTED_GAP_PX = 7;
    private static final int BADGE_PX = 16;

    private static final double HEIGHT_GAP_PX = 8;
    private static final Stroke TRUTH =
            new BasicStroke(1.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {5, 3}, 0);

    private final MapScene.Robot robot;
    private final MapView view;
    private final Color color;
    private final double radiusPx;

    RobotGlyph(MapScene.Robot robot, MapView view) {
        this.robot = robot;
        this.view = view;
        this.color = RobotColors.of(robot.number());
        this.radiusPx = Math.max(SMALLEST_PX, robot.bodyMm() * view.pxPerMm());
    }

    int number() {
        return robot.number();
    }

    /** Returns whether a pixel is on the body, at the reported or at the true pose. */
    boolean covers(Point2D pixel) {
        Pose truth = robot.truth();
        return pixel.distance(pixel(robot.reported())) <= radiusPx
                || (truth != null && pixel.distance(pixel(truth)) <= radiusPx);
    }

    private Point2D pixel(Pose at) {
        return view.pixel(at.xMm(), at.yMm());
    }

    void paintTrail(Graphics2D g) {
        Path2D way = new Path2D.Double();
        robot.trail().trace(way, TRAIL_STEP_PX / view.pxPerMm());
        if (way.getCurrentPoint() == null) {
            return;
        }
        way.lineTo(robot.reported().xMm(), robot.reported().yMm());
        g.setStroke(TRAIL);
        g.setColor(DrawingColors.translucent(color, TRAIL_OPACITY));
        g.draw(view.transform().createTransformedShape(way));
    }

    /** Draws what the robot has reserved as wide as the robot, and the way to its place as a line. */
    void paintWay(Graphics2D g) {
        if (!robot.way().reserved().isEmpty()) {
            g.setStroke(new BasicStroke((float) (2 * radiusPx), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
            g.setColor(DrawingColors.translucent(color, RESERVED_OPACITY));
            g.draw(line(robot.way().reserved()));
        }
        if (!robot.way().corners().isEmpty()) {
            g.setStroke(TRAIL);
            g.setColor(color);
            Path2D line = line(robot.way().corners());
            Point2D place = line.getCurrentPoint();
            g.draw(line);
            g.draw(new Ellipse2D.Double(place.getX() - PLACE_PX, place.getY() - PLACE_PX, 2 * PLACE_PX, 2 * PLACE_PX));
        }
    }

    /** Returns the line from the robot through places. */
    private Path2D line(List<Pose> places) {
        Path2D line = new Path2D.Double();
        moveTo(line, robot.reported(), 0, 0);
        places.forEach(place -> moveTo(line, place, 0, 0));
        return line;
    }

    /** Draws the ellipse within which the robot is with a probability of 95 %. */
    void paintUncertainty(Graphics2D g) {
        Uncertainty is = robot.uncertainty();
        if (!is.isKnown()) {
            return;
        }
        double mean = (is.xx() + is.yy()) / 2;
        double apart = Math.hypot((is.xx() - is.yy()) / 2, is.xy());
        AffineTransform onScreen = view.transform();
        onScreen.translate(robot.reported().xMm(), robot.reported().yMm());
        onScreen.rotate(Math.atan2(2 * is.xy(), is.xx() - is.yy()) / 2);
        onScreen.scale(SIGMAS_OF_95 * Math.sqrt(mean + apart), SIGMAS_OF_95 * Math.sqrt(Math.max(0, mean - apart)));
        Shape ellipse = onScreen.createTransformedShape(new Ellipse2D.Double(-1, -1, 2, 2));
        g.setColor(DrawingColors.translucent(color, 0.15));
        g.fill(ellipse);
        g.setColor(DrawingColors.translucent(color, TRAIL_OPACITY));
        g.setStroke(TRAIL);
        g.draw(ellipse);
    }

    void paintBody(Graphics2D g) {
        g.setColor(DrawingColors.translucent(color, robot.connected() ? 0.75 : 0.27));
        g.fill(circle(robot.reported()));
        g.setColor(color);
        g.setStroke(TRAIL);
        g.draw(circle(robot.reported()));
        g.fill(nose(robot.reported()));
        if (isAlarming()) {
            paintAlarm(g);
        }
    }

    /** Returns whether the robot may still move after a stop. */
    boolean isAlarming() {
        return robot.stopUnconfirmed();
    }

    /** Draws the four corners of a square around the robot. */
    void paintSelection(Graphics2D g) {
        g.setColor(Palette.text());
        g.setStroke(SELECTED);
        Point2D middle = pixel(robot.reported());
        double far = radiusPx + SELECTED_GAP_PX;
        double near = far * 0.55;
        for (int corner = 0; corner < 4; corner++) {
            double right = corner % 2 == 0 ? 1 : -1;
            double down = corner < 2 ? 1 : -1;
            double x = middle.getX() + right * far;
            double y = middle.getY() + down * far;
            g.draw(new LineArt()
                    .line(middle.getX() + right * near, y, x, y, x, middle.getY() + down * near)
                    .shape());
        }
    }

    /** Draws two rings around the robot. */
    private void paintAlarm(Graphics2D g) {
        g.setColor(Palette.error());
        g.setStroke(ALARM);
        Point2D middle = pixel(robot.reported());
        for (double radius = radiusPx + ALARM_GAP_PX; radius <= radiusPx + 2 * ALARM_GAP_PX; radius += ALARM_GAP_PX) {
            g.draw(new Ellipse2D.Double(middle.getX() - radius, middle.getY() - radius, 2 * radius, 2 * radius));
        }
    }

    void paintTruth(Graphics2D g) {
        Pose truth = robot.truth();
        if (truth != null) {
            g.setStroke(TRUTH);
            g.setColor(Palette.mixed(0.85));
            g.draw(circle(truth));
            g.draw(nose(truth));
        }
    }

    /** Draws the number, and the mark of an unconfirmed stop beside the robot, where they cover no other label. */
    void paintNumber(Graphics2D g, LabelRoom room) {
        Point2D middle = pixel(robot.reported());
        NumberBadge badge = new NumberBadge(robot.number(), UIScale.scale(BADGE_PX));
        if (room.take(around(middle, badge.width(), badge.height()))) {
            String text = robot.connected() ? "" + robot.number() : robot.number() + "?";
            badge.paint(g, middle.getX(), middle.getY(), text);
        }
        if (isAlarming()) {
            paintMark(g, room, middle);
        }
    }

    private void paintMark(Graphics2D g, LabelRoom room, Point2D middle) {
        String mark = TEXTS.get("stopUnconfirmed");
        FontMetrics metrics = g.getFontMetrics();
        double aside = radiusPx + 2 * ALARM_GAP_PX + 4;
        double x = middle.getX() + aside;
        double y = middle.getY() - aside / 2;
        if (room.take(
                new Rectangle2D.Double(x, y - metrics.getAscent(), metrics.stringWidth(mark), metrics.getHeight()))) {
            g.setColor(Palette.error());
            g.drawString(mark, (float) x, (float) y);
        }
    }

    /** Draws the height of a robot in the air to the right of it, where that covers no other label. */
    void paintHeight(Graphics2D g, LabelRoom room) {
        if (!robot.isInAir()) {
            return;
        }
        String text = TEXTS.get("height", robot.metres());
        FontMetrics metrics = g.getFontMetrics();
        Point2D middle = pixel(robot.reported());
        double width = metrics.stringWidth(text);
        double x = middle.getX() + radiusPx + HEIGHT_GAP_PX;
        Rectangle2D label = around(
                new Point2D.Double(Math.min(x, view.width() - width) + width / 2, middle.getY()),
                width,
                metrics.getHeight());
        if (room.take(label)) {
            g.setColor(DrawingColors.translucent(Palette.paper(), 0.75));
            g.fill(label);
            g.setColor(robot.connected() ? Palette.text() : Palette.mixed(0.6));
            g.drawString(text, (float) label.getX(), (float) (label.getY() + metrics.getAscent()));
        }
    }

    /** Draws that the robot waits, below it or above it, where that covers no other label. */
    void paintWaits(Graphics2D g, LabelRoom room) {
        if (robot.way().waits().isEmpty()) {
            return;
        }
        OptionalInt other = robot.way().waitsFor();
        String text = other.isPresent() ? TEXTS.get("waitsFor", other.getAsInt()) : TEXTS.get("waits");
        FontMetrics metrics = g.getFontMetrics();
        double width = metrics.stringWidth(text);
        Point2D middle = pixel(robot.reported());
        double x = Math.max(0, Math.min(middle.getX(), view.width() - width / 2) - width / 2);
        double aside = radiusPx + metrics.getHeight();
        for (double y : new double[] {middle.getY() + aside, middle.getY() - aside}) {
            Rectangle2D label = around(new Point2D.Double(x + width / 2, y), width, metrics.getHeight());
            if (room.take(label)) {
                g.setColor(DrawingColors.translucent(Palette.paper(), 0.75));
                g.fill(label);
                g.setColor(Palette.text());
                g.drawString(text, (float) x, (float) (label.getY() + metrics.getAscent()));
                return;
            }
        }
    }

    private static Rectangle2D around(Point2D middle, double width, double height) {
        return new Rectangle2D.Double(middle.getX() - width / 2, middle.getY() - height / 2, width, height);
    }

    private Ellipse2D circle(Pose at) {
        Point2D middle = pixel(at);
        return new Ellipse2D.Double(middle.getX() - radiusPx, middle.getY() - radiusPx, 2 * radiusPx, 2 * radiusPx);
    }

    /** Returns a triangle on the rim that points in the robot's heading. */
    private Path2D nose(Pose at) {
        Path2D triangle = new Path2D.Double();
        double tip = radiusPx + Math.max(5, radiusPx * 0.35);
        moveTo(triangle, at, tip, 0);
        moveTo(triangle, at, radiusPx, 24);
        moveTo(triangle, at, radiusPx, -24);
        triangle.closePath();
        return triangle;
    }

    private void moveTo(Path2D path, Pose at, double pixels, double aside) {
        double angle = Math.toRadians(at.headingDeg() + aside);
        double x = pixel(at).getX() + pixels * Math.cos(angle);
        double y = pixel(at).getY() - pixels * Math.sin(angle);
        if (path.getCurrentPoint() == null) {
            path.moveTo(x, y);
        } else {
            path.lineTo(x, y);
        }
    }
}

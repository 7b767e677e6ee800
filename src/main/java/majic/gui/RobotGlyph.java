package majic.gui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.List;
import majic.bot.Pose;

/** Draws one robot of the map: its trail, where it believes it is, where it is. */
final class RobotGlyph {
    /** A body is never drawn smaller, so that a Hemisson can be found in a hall. */
    private static final double SMALLEST_PX = 8;

    private static final Stroke TRAIL = new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
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
        this.radiusPx = Math.max(SMALLEST_PX, robot.bodyMm() * view.pixelsPerMm());
    }

    /** Whether a pixel is on the body. */
    boolean covers(double x, double y) {
        Pose at = robot.believed();
        return Math.hypot(x - view.x(at.xMm()), y - view.y(at.yMm())) <= radiusPx;
    }

    void paintTrail(Graphics2D g) {
        List<MapScene.Point> trail = robot.trail();
        if (trail.size() < 2) {
            return;
        }
        Path2D path = new Path2D.Double();
        path.moveTo(view.x(trail.get(0).xMm()), view.y(trail.get(0).yMm()));
        trail.forEach(point -> path.lineTo(view.x(point.xMm()), view.y(point.yMm())));
        path.lineTo(view.x(robot.believed().xMm()), view.y(robot.believed().yMm()));
        g.setStroke(TRAIL);
        g.setColor(withAlpha(130));
        g.draw(path);
    }

    void paintBody(Graphics2D g) {
        g.setColor(withAlpha(robot.connected() ? 190 : 70));
        g.fill(circle(robot.believed()));
        g.setColor(color);
        g.setStroke(TRAIL);
        g.draw(circle(robot.believed()));
        g.fill(nose(robot.believed()));
        paintNumber(g);
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

    private void paintNumber(Graphics2D g) {
        String text = robot.connected() ? "" + robot.number() : robot.number() + "?";
        FontMetrics metrics = g.getFontMetrics();
        float x = (float) (view.x(robot.believed().xMm()) - metrics.stringWidth(text) / 2.0);
        float y = (float) (view.y(robot.believed().yMm()) + (metrics.getAscent() - metrics.getDescent()) / 2.0);
        g.setColor(luminance() > 0.6 ? Color.BLACK : Color.WHITE);
        g.drawString(text, x, y);
    }

    private Ellipse2D circle(Pose at) {
        return new Ellipse2D.Double(
                view.x(at.xMm()) - radiusPx, view.y(at.yMm()) - radiusPx, 2 * radiusPx, 2 * radiusPx);
    }

    /** A triangle on the rim that points where the robot looks. */
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
        double x = view.x(at.xMm()) + pixels * Math.cos(angle);
        double y = view.y(at.yMm()) - pixels * Math.sin(angle);
        if (path.getCurrentPoint() == null) {
            path.moveTo(x, y);
        } else {
            path.lineTo(x, y);
        }
    }

    private Color withAlpha(int alpha) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
    }

    private double luminance() {
        return (0.299 * color.getRed() + 0.587 * color.getGreen() + 0.114 * color.getBlue()) / 255;
    }
}

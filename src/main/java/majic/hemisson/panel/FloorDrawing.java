package majic.hemisson.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import majic.bot.Pose;
import majic.hemisson.readings.Clearance;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.panel.map.StartMark;
import majic.panel.map.TrailContent;
import majic.text.Texts;

/**
 * The floor with the estimated way of the robot: dashed and marked as an estimate, because nothing measures it.
 * {@link #poseReported} is for the driver's threads, everything else for the event thread.
 */
final class FloorDrawing extends TrailContent {
    private static final Reach REACH = new Reach(0.18, 400, 900, 200);
    private static final double LEAST_RADIUS_PX = 7;
    private static final Texts TEXTS = Texts.of(FloorDrawing.class);
    private static final int INSET = 6;

    /** What the scale takes at the foot of the map, and how narrow a map has no room beside it. */
    private static final int SCALE_PX = 26;

    private static final int NARROW_PX = 210;

    private Pose pose = Pose.START;
    private boolean connected;

    FloorDrawing() {
        super(REACH, false);
    }

    void show(HemissonScene view) {
        pose = view.state().pose();
        connected = view.isConnected();
    }

    @Override
    public Pose pose() {
        return pose;
    }

    @Override
    public void paint(Graphics2D pen, MapView view) {
        DrawingColors colors =
                connected ? DrawingColors.current() : DrawingColors.current().faded();
        new StartMark(view, pose, radiusPx(view)).paint(pen, colors);
        paintTrail(pen, view, colors);
        paintRobot(pen, view, colors);
        paintMark(pen, view);
    }

    private static void paintMark(Graphics2D pen, MapView view) {
        String mark = TEXTS.get("estimate");
        FontMetrics metrics = pen.getFontMetrics();
        int foot = view.width() < UIScale.scale(NARROW_PX) ? UIScale.scale(SCALE_PX) : 0;
        pen.setColor(DrawingColors.current().faint());
        pen.drawString(
                mark,
                view.width() - metrics.stringWidth(mark) - INSET,
                view.height() - foot - INSET - metrics.getDescent());
    }

    private static double radiusPx(MapView view) {
        return Math.max(LEAST_RADIUS_PX, Clearance.HULL_MM * view.pxPerMm());
    }

    /** A disc to scale, or as small as can be found, with an arrow ahead. */
    private void paintRobot(Graphics2D pen, MapView view, DrawingColors colors) {
        Point2D middle = view.pixel(pose.xMm(), pose.yMm());
        double radius = radiusPx(view);
        Graphics2D robot = (Graphics2D) pen.create();
        robot.translate(middle.getX(), middle.getY());
        robot.rotate(-Math.toRadians(pose.headingDeg() + MapView.Y_UP - view.upDeg()));
        robot.setColor(colors.grey(0.2));
        robot.fill(new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius));
        robot.setColor(colors.line());
        robot.setStroke(DrawingColors.stroke(1.3));
        robot.draw(new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius));
        robot.fill(arrow(0.75 * radius));
        robot.dispose();
    }

    private static Path2D arrow(double length) {
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(length, 0);
        arrow.lineTo(-0.6 * length, 0.6 * length);
        arrow.lineTo(-0.2 * length, 0);
        arrow.lineTo(-0.6 * length, -0.6 * length);
        arrow.closePath();
        return arrow;
    }
}

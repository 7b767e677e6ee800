package majic.shared.panel;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.panel.map.TrailContent;
import majic.panel.map.TrailDrawing;

/**
 * A robot of any kind on its floor, to scale: a disc of its size with an arrow ahead, its start and its path.
 * {@link #poseReported} is for the driver's threads, everything else for the event dispatch thread.
 */
final class SharedDrawing extends TrailContent {
    private static final Reach REACH = new Reach(0.09, 1200, 4200, 700);

    /** The arrow is at least this long, so that the robot is found on a map at a small scale. */
    private static final double LEAST_ARROW_PX = 7;

    private Pose pose = Pose.START;
    private double bodyMm;
    private boolean current;

    /** Draws nothing before {@link #show}. */
    SharedDrawing(boolean measured) {
        super(REACH, measured);
    }

    void show(Pose newPose, double newBodyMm, boolean isCurrent) {
        pose = newPose;
        bodyMm = newBodyMm;
        current = isCurrent;
    }

    @Override
    public Pose pose() {
        return pose;
    }

    @Override
    public void paint(Graphics2D pen, MapView view) {
        if (bodyMm == 0) {
            paintNoReading(pen, view);
            return;
        }
        DrawingColors colors =
                current ? DrawingColors.current() : DrawingColors.current().faded();
        TrailDrawing.paintStart(pen, view, colors);
        paintTrail(pen, view, colors);
        Graphics2D robot = inRobotFrame(pen, view, pose);
        Shape hull = new Ellipse2D.Double(-bodyMm, -bodyMm, 2 * bodyMm, 2 * bodyMm);
        robot.setColor(colors.grey(0.15));
        robot.fill(hull);
        robot.setColor(colors.grey(0.85));
        robot.setStroke(DrawingColors.stroke(1.3 / view.pxPerMm()));
        robot.draw(hull);
        robot.setColor(colors.line());
        robot.fill(arrow(Math.max(0.6 * bodyMm, LEAST_ARROW_PX / view.pxPerMm())));
        robot.dispose();
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

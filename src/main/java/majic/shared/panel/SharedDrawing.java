package majic.shared.panel;

import java.awt.Graphics2D;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.panel.map.RobotDisc;
import majic.panel.map.StartMark;
import majic.panel.map.TrailContent;

/**
 * A robot of any kind on its floor, to scale: a disc of its size with an arrow ahead, its start and its path.
 * {@link #poseReported} is for the driver's threads, everything else for the event dispatch thread.
 */
final class SharedDrawing extends TrailContent {
    private static final Reach REACH = new Reach(0.09, 1200, 4200, 700);

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
        new StartMark(view, pose, bodyMm * view.pxPerMm()).paint(pen, colors);
        paintTrail(pen, view, colors);
        Graphics2D robot = inRobotFrame(pen, view, pose);
        new RobotDisc(bodyMm, false).paint(robot, colors, view.pxPerMm());
        robot.dispose();
    }
}

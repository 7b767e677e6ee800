package majic.ros.panel;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.Echoes;
import majic.panel.map.EchoesDrawing;
import majic.panel.map.MapView;
import majic.panel.map.TrailContent;
import majic.panel.map.TrailDrawing;
import org.jspecify.annotations.Nullable;

/**
 * A ROS robot on its floor, to scale: its start, its path, the echoes of its scanner along that path, and the scan now.
 * {@link #record} is for the driver's threads, everything else for the event dispatch thread.
 */
final class RosDrawing extends TrailContent {
    private static final Reach REACH = new Reach(0.09, 1200, 4200, 700);

    private final Echoes echoes = new Echoes();
    private final Object recording = new Object();
    private @Nullable ScanEchoes recorded;
    private @Nullable RosScene scene;
    private Pose pose = Pose.START;

    RosDrawing() {
        super(REACH, true);
    }

    /** Adds a pose to the path, and the echoes of a scan that was not added yet. */
    void record(Pose now, Optional<ScanEchoes> scan) {
        poseReported(now);
        synchronized (recording) {
            scan.filter(newest -> !newest.equals(recorded)).ifPresent(newest -> {
                recorded = newest;
                addEchoes(newest, now);
            });
        }
    }

    private void addEchoes(ScanEchoes scan, Pose from) {
        double cos = Math.cos(Math.toRadians(from.headingDeg()));
        double sin = Math.sin(Math.toRadians(from.headingDeg()));
        for (int beam = 0; beam < scan.beams(); beam++) {
            if (scan.hasEcho(beam)) {
                double x = scan.xMm(beam);
                double y = scan.yMm(beam);
                echoes.add(new Echoes.Echo(
                        from.xMm() + x * cos - y * sin, from.yMm() + x * sin + y * cos, scan.atNanos()));
            }
        }
    }

    void show(RosScene newScene, Pose newPose) {
        scene = newScene;
        pose = newPose;
    }

    @Override
    public Pose pose() {
        return pose;
    }

    @Override
    protected void extend(Rectangle2D extent) {
        echoes.all().forEach(echo -> extent.add(echo.xMm(), echo.yMm()));
    }

    @Override
    public void clear() {
        super.clear();
        echoes.clear();
    }

    @Override
    public void paint(Graphics2D pen, MapView view) {
        RosScene shown = scene;
        if (shown == null) {
            paintNoReading(pen, view);
            return;
        }
        DrawingColors colors = shown.isConnected()
                ? DrawingColors.current()
                : DrawingColors.current().faded();
        TrailDrawing.paintStart(pen, view, colors);
        Graphics2D robot = inRobotFrame(pen, view, pose);
        shown.scan().ifPresent(scan -> ScanDrawing.paintSeen(robot, scan, colors));
        paintTrail(pen, view, colors);
        Graphics2D echoPen = (Graphics2D) pen.create();
        new EchoesDrawing(colors, view).paint(echoPen, echoes.all(), nowNanos(shown));
        echoPen.dispose();
        new RosBodyDrawing(shown, colors, view.pxPerMm()).paint(robot);
        robot.dispose();
    }

    /** The newest scan is the present: without one, the age of the echoes stays as it was. */
    private long nowNanos(RosScene shown) {
        synchronized (recording) {
            ScanEchoes last = shown.scan().orElse(recorded);
            return last == null ? 0 : last.atNanos();
        }
    }
}

package majic.ros.panel;

import java.awt.Graphics2D;
import java.util.Optional;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.EchoContent;
import majic.panel.map.RobotDisc;
import org.jspecify.annotations.Nullable;

/**
 * A ROS robot on its floor, to scale: its start, its path, the echoes of its scanner along that path, and the scan now.
 * {@link #record} is for the driver's threads, everything else for the event dispatch thread.
 */
final class RosDrawing extends EchoContent<RosDrawing.PlacedScene> {
    private static final Reach REACH = new Reach(0.09, 1200, 4200, 700);

    private final Object recording = new Object();
    private @Nullable ScanEchoes recorded;

    /**
     * A snapshot of the robot, and where the robot is.
     *
     * @param scene the snapshot
     * @param pose on the floor
     */
    record PlacedScene(RosScene scene, Pose pose) {}

    RosDrawing() {
        super(REACH);
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
        for (int beam = 0; beam < scan.beams(); beam++) {
            if (scan.hasEcho(beam)) {
                addEcho(from, scan.xMm(beam), scan.yMm(beam), scan.atNanos());
            }
        }
    }

    void show(RosScene newScene, Pose newPose) {
        showScene(new PlacedScene(newScene, newPose));
    }

    @Override
    protected Pose pose(PlacedScene placed) {
        return placed.pose();
    }

    @Override
    protected double radiusMm(PlacedScene placed) {
        return placed.scene().robot().radiusMm();
    }

    @Override
    protected boolean isConnected(PlacedScene placed) {
        return placed.scene().isConnected();
    }

    /** The newest scan is the present: without one, the age of the echoes stays as it was. */
    @Override
    protected long nowNanos(PlacedScene placed) {
        synchronized (recording) {
            ScanEchoes last = placed.scene().scan().orElse(recorded);
            return last == null ? 0 : last.atNanos();
        }
    }

    @Override
    protected void paintSensing(Graphics2D pen, PlacedScene placed, DrawingColors colors, double pxPerMm) {
        placed.scene().scan().ifPresent(scan -> ScanDrawing.paintSeen(pen, scan, colors));
    }

    @Override
    protected void paintBody(Graphics2D pen, PlacedScene placed, DrawingColors colors, double pxPerMm) {
        RosScene scene = placed.scene();
        boolean touches = !scene.contacts().isEmpty() && scene.isConnected();
        new RobotDisc(scene.robot().radiusMm(), touches).paint(pen, colors, pxPerMm);
    }
}

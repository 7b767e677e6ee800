package majic.panel.map;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import org.jspecify.annotations.Nullable;

/**
 * A robot on its floor, to scale: its start, its path, the echoes of its sensors along that path, what they sense now,
 * and its body. {@link #addEcho} and {@link #poseReported} may be called on the driver's threads, everything else on
 * the event dispatch thread.
 *
 * @param <S> a snapshot of the robot
 */
public abstract class EchoContent<S> extends TrailContent {
    private final Echoes echoes = new Echoes();
    private @Nullable S shown;

    /**
     * Creates a floor without a trail and echoes, of a robot that measures its path.
     *
     * @param reach how much of the floor is visible
     */
    protected EchoContent(Reach reach) {
        super(reach, true);
    }

    /**
     * Adds an echo to the floor.
     *
     * @param robot its pose when the echo was received
     * @param xMm from the robot, ahead
     * @param yMm from the robot, to the left
     * @param atNanos when it was received
     */
    protected final void addEcho(Pose robot, double xMm, double yMm, long atNanos) {
        Pose place = robot.plus(new Pose(xMm, yMm, 0));
        echoes.add(new Echoes.Echo(place.xMm(), place.yMm(), atNanos));
    }

    /**
     * Shows a snapshot from the next painting on.
     *
     * @param scene of the robot
     */
    protected final void showScene(S scene) {
        shown = scene;
    }

    @Override
    public final Pose pose() {
        S scene = shown;
        return scene == null ? Pose.START : pose(scene);
    }

    @Override
    protected final void extend(Rectangle2D extent) {
        echoes.all().forEach(echo -> extent.add(echo.xMm(), echo.yMm()));
    }

    @Override
    public final void clear() {
        super.clear();
        echoes.clear();
    }

    @Override
    public final void paint(Graphics2D pen, MapView view) {
        S scene = shown;
        if (scene == null) {
            paintNoReading(pen, view);
            return;
        }
        DrawingColors colors = isConnected(scene)
                ? DrawingColors.current()
                : DrawingColors.current().faded();
        new StartMark(view, pose(scene), radiusMm(scene) * view.pxPerMm()).paint(pen, colors);
        Graphics2D robot = inRobotFrame(pen, view, pose(scene));
        paintSensing(robot, scene, colors, view.pxPerMm());
        paintTrail(pen, view, colors);
        Graphics2D echoPen = (Graphics2D) pen.create();
        new EchoesDrawing(colors, view).paint(echoPen, echoes.all(), nowNanos(scene));
        echoPen.dispose();
        paintBody(robot, scene, colors, view.pxPerMm());
        robot.dispose();
    }

    /** Returns where the robot is on the floor. */
    protected abstract Pose pose(S scene);

    /** Returns the radius of a circle that the robot fits into, mm. */
    protected abstract double radiusMm(S scene);

    /** Returns whether the robot is connected; otherwise all is painted faded. */
    protected abstract boolean isConnected(S scene);

    /** Returns the time by which the ages of echoes are measured. */
    protected abstract long nowNanos(S scene);

    /** Paints what the sensors sense now, below the trail, with a pen in the robot's frame, mm. */
    protected abstract void paintSensing(Graphics2D pen, S scene, DrawingColors colors, double pxPerMm);

    /** Paints the body, above all else, with a pen in the robot's frame, mm. */
    protected abstract void paintBody(Graphics2D pen, S scene, DrawingColors colors, double pxPerMm);
}

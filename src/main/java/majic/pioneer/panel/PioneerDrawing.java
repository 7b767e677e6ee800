package majic.pioneer.panel;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.Echoes;
import majic.panel.map.EchoesDrawing;
import majic.panel.map.MapView;
import majic.panel.map.TrailContent;
import majic.panel.map.TrailDrawing;
import majic.pioneer.state.Model;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.SonarDisc;
import majic.pioneer.state.SonarScan;
import org.jspecify.annotations.Nullable;

/**
 * A Pioneer on its floor, to scale: its start, its path, the echoes along that path and the cones of its sonars now.
 * {@link #record} is for the driver's threads, everything else for the event thread.
 */
final class PioneerDrawing extends TrailContent {
    private static final Reach REACH = new Reach(0.065, 2000, 4200, 900);

    private final Echoes echoes = new Echoes();
    private @Nullable PioneerScene scene;

    PioneerDrawing() {
        super(REACH, true);
    }

    /** Adds a pose to the path, and its echoes. */
    void record(Model model, PioneerState state) {
        poseReported(state.pose());
        if (state.sip().sonar().count() > 0) {
            model.discs().stream()
                    .filter(disc -> state.sonar().atNanos(disc.number()) == state.atNanos())
                    .filter(disc -> state.sonar().rangeMm(disc.number()) < SonarScan.NOTHING_MM)
                    .forEach(disc -> echoes.add(echo(disc, state)));
        }
    }

    private static Echoes.Echo echo(SonarDisc disc, PioneerState state) {
        double range = state.sonar().rangeMm(disc.number());
        Pose pose = state.pose();
        double cos = Math.cos(Math.toRadians(pose.headingDeg()));
        double sin = Math.sin(Math.toRadians(pose.headingDeg()));
        double x = disc.echoX(range);
        double y = disc.echoY(range);
        return new Echoes.Echo(pose.xMm() + x * cos - y * sin, pose.yMm() + x * sin + y * cos, state.atNanos());
    }

    void show(PioneerScene newScene) {
        scene = newScene;
    }

    @Override
    public Pose pose() {
        PioneerScene shown = scene;
        return shown == null ? Pose.START : shown.state().pose();
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
        PioneerScene shown = scene;
        if (shown == null) {
            paintNoReading(pen, view);
            return;
        }
        DrawingColors colors = shown.isConnected()
                ? DrawingColors.current()
                : DrawingColors.current().faded();
        TrailDrawing.paintStart(pen, view, colors);
        Graphics2D robot = inRobotFrame(pen, view, shown.state().pose());
        if (shown.isConnected() && shown.state().sonarOn()) {
            new ConesDrawing(shown.state(), colors, view.pxPerMm())
                    .paint(robot, shown.model().discs());
        }
        paintTrail(pen, view, colors);
        Graphics2D echoPen = (Graphics2D) pen.create();
        new EchoesDrawing(colors, view)
                .paint(echoPen, echoes.all(), shown.state().atNanos());
        echoPen.dispose();
        new PioneerBodyDrawing(shown, colors, view.pxPerMm()).paint(robot);
        robot.dispose();
    }
}

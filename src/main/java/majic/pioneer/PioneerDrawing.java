package majic.pioneer;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import majic.panel.Echoes;
import majic.panel.Ink;
import majic.panel.MapContent;
import majic.panel.MapView;
import majic.panel.Trail;
import majic.panel.WayDrawing;
import org.jspecify.annotations.Nullable;

/**
 * A Pioneer on its floor, to scale: where it started, the way it came, what its sonars met on that way and what they hear
 * now. {@link #hear} is for the driver's threads, everything else for the event thread.
 */
final class PioneerDrawing implements MapContent {
    /** The robot is drawn at least this large, as long as that leaves {@link #LEAST_REACH_MM} around it. */
    private static final double PX_PER_MM = 0.065;

    private static final double LEAST_REACH_MM = 2000;
    private static final double MOST_REACH_MM = 4200;
    private static final double MARGIN_MM = 900;

    private final Trail trail = new Trail();
    private final Echoes echoes = new Echoes();
    private final WayDrawing way = WayDrawing.measured(trail);
    private @Nullable PioneerScene scene;

    /** Remembers where the robot was and what it heard there. */
    void hear(Model model, PioneerState state) {
        trail.add(state.pose());
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
    public Rectangle2D extent() {
        Rectangle2D extent = new Rectangle2D.Double(pose().xMm(), pose().yMm(), 0, 0);
        extent.add(0, 0);
        trail.extend(extent);
        echoes.all().forEach(echo -> extent.add(echo.xMm(), echo.yMm()));
        return new Rectangle2D.Double(
                extent.getX() - MARGIN_MM,
                extent.getY() - MARGIN_MM,
                extent.getWidth() + 2 * MARGIN_MM,
                extent.getHeight() + 2 * MARGIN_MM);
    }

    @Override
    public double nearPxPerMm(int sidePx) {
        double reach = Math.max(LEAST_REACH_MM, Math.min(MOST_REACH_MM, sidePx / 2.0 / PX_PER_MM));
        return sidePx / 2.0 / reach;
    }

    @Override
    public void clear() {
        trail.clear();
        echoes.clear();
    }

    @Override
    public void paint(Graphics2D pen, MapView view) {
        PioneerScene shown = scene;
        if (shown == null) {
            paintNothing(pen, view);
            return;
        }
        Ink ink = shown.isConnected() ? Ink.ofTheLook() : Ink.ofTheLook().faded();
        WayDrawing.paintStart(pen, view, ink);
        Graphics2D robot = inRobotFrame(pen, view, shown.state().pose());
        if (shown.isConnected() && shown.state().sonarOn()) {
            new ConesDrawing(shown.state(), ink, view.pxPerMm())
                    .paint(robot, shown.model().discs());
        }
        way.paint(pen, view, ink);
        Graphics2D echoPen = (Graphics2D) pen.create();
        new EchoesDrawing(ink, view).paint(echoPen, echoes.all(), shown.state().atNanos());
        echoPen.dispose();
        new BodyDrawing(shown, ink, view.pxPerMm()).paint(robot);
        robot.dispose();
    }

    private static void paintNothing(Graphics2D pen, MapView view) {
        String text = "no reading yet";
        FontMetrics metrics = pen.getFontMetrics();
        pen.setColor(Ink.ofTheLook().grey(0.7));
        pen.drawString(text, (view.width() - metrics.stringWidth(text)) / 2, view.height() / 2);
    }

    /** x ahead, y to the left, mm. */
    private static Graphics2D inRobotFrame(Graphics2D pen, MapView view, Pose pose) {
        Graphics2D robot = (Graphics2D) pen.create();
        robot.transform(view.transform());
        robot.translate(pose.xMm(), pose.yMm());
        robot.rotate(Math.toRadians(pose.headingDeg()));
        return robot;
    }
}

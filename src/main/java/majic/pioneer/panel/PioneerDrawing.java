package majic.pioneer.panel;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.panel.DrawingColors;
import majic.panel.map.EchoContent;
import majic.pioneer.state.Model;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.SonarDisc;
import majic.pioneer.state.SonarScan;

/**
 * A Pioneer on its floor, to scale: its start, its path, the echoes along that path and the cones of its sonars now.
 * {@link #record} is for the driver's threads, everything else for the event thread.
 */
final class PioneerDrawing extends EchoContent<PioneerScene> {
    private static final double POINT_PX = 2.5;
    private static final Reach REACH = new Reach(0.065, 2000, 4200, 900);

    PioneerDrawing() {
        super(REACH);
    }

    /** Adds a pose to the path, and its echoes. */
    void record(Model model, PioneerState state) {
        poseReported(state.pose());
        if (state.sip().readings() > 0) {
            model.discs().stream()
                    .filter(disc -> state.sonar().atNanos(disc.number()) == state.atNanos())
                    .filter(disc -> state.sonar().rangeMm(disc.number()) < SonarScan.NOTHING_MM)
                    .forEach(disc -> addEcho(disc, state));
        }
    }

    private void addEcho(SonarDisc disc, PioneerState state) {
        double range = state.sonar().rangeMm(disc.number());
        addEcho(state.pose(), disc.echoX(range), disc.echoY(range), state.atNanos());
    }

    void show(PioneerScene newScene) {
        showScene(newScene);
    }

    @Override
    protected Pose pose(PioneerScene scene) {
        return scene.state().pose();
    }

    @Override
    protected double radiusMm(PioneerScene scene) {
        return scene.model().hull().swingMm();
    }

    @Override
    protected boolean isConnected(PioneerScene scene) {
        return scene.isConnected();
    }

    @Override
    protected long nowNanos(PioneerScene scene) {
        return scene.state().atNanos();
    }

    @Override
    protected void paintSensing(Graphics2D pen, PioneerScene scene, DrawingColors colors, double pxPerMm) {
        if (scene.isConnected() && scene.state().sonarOn()) {
            new ConesDrawing(scene.state(), colors, pxPerMm)
                    .paint(pen, scene.model().discs());
        }
        if (scene.isConnected()) {
            scene.laser().ifPresent(scan -> paintLaser(pen, scan, scene.state().pose(), colors, pxPerMm));
        }
    }

    /** Draws the echoes of a scan as points, from where the robot was when it measured them. */
    private static void paintLaser(Graphics2D pen, RangeScan scan, Pose now, DrawingColors colors, double pxPerMm) {
        Pose then = scan.odometry().seenFrom(now);
        double side = POINT_PX / pxPerMm;
        pen.setColor(colors.accent());
        for (int index = 0; index < scan.size(); index++) {
            float range = scan.rangeMm(index);
            if (Float.isFinite(range)) {
                Pose echo = then.plus(scan.sensor().beams().get(index).mount()).after(range, 0);
                pen.fill(new Rectangle2D.Double(echo.xMm() - side / 2, echo.yMm() - side / 2, side, side));
            }
        }
    }

    @Override
    protected void paintBody(Graphics2D pen, PioneerScene scene, DrawingColors colors, double pxPerMm) {
        new PioneerBodyDrawing(scene, colors, pxPerMm).paint(pen);
    }
}

package majic.pioneer.panel;

import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.util.List;
import majic.panel.DrawingColors;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.SonarDisc;
import majic.pioneer.state.SonarScan;

/**
 * The cone of every sonar disc up to its range, with a bar at the echo. A cone lights up when its disc fires and fades
 * within half a second; one that has not fired for 2 s is not drawn.
 */
final class ConesDrawing {
    private static final double CONE_DEG = 30;
    private static final double BAR_DEG = 20;
    private static final double AFTERGLOW_S = 0.5;
    private static final double SILENCE_S = 2;

    private final SonarScan scan;
    private final long nowNanos;
    private final DrawingColors colors;
    private final double pxPerMm;

    ConesDrawing(PioneerState state, DrawingColors colors, double pxPerMm) {
        this.scan = state.sonar();
        this.nowNanos = state.atNanos();
        this.colors = colors;
        this.pxPerMm = pxPerMm;
    }

    /** Paints in the robot's frame, mm: first what lies below. */
    void paint(Graphics2D pen, List<SonarDisc> discs) {
        List<SonarDisc> recent = discs.stream().filter(this::isRecent).toList();
        recent.forEach(disc -> paintCone(pen, disc));
        recent.stream().filter(this::hasEcho).forEach(disc -> paintEcho(pen, disc));
    }

    private boolean isRecent(SonarDisc disc) {
        return scan.hasReading(disc.number()) && ageSeconds(disc) < SILENCE_S;
    }

    private double ageSeconds(SonarDisc disc) {
        return (nowNanos - scan.atNanos(disc.number())) / 1e9;
    }

    private boolean hasEcho(SonarDisc disc) {
        return scan.rangeMm(disc.number()) < SonarScan.NOTHING_MM;
    }

    private void paintCone(Graphics2D pen, SonarDisc disc) {
        double glow = Math.max(0, 1 - ageSeconds(disc) / AFTERGLOW_S);
        pen.setColor(colors.wash(hasEcho(disc) ? 0.08 + 0.12 * glow : 0.02 + 0.03 * glow));
        pen.fill(arc(disc, CONE_DEG, Arc2D.PIE));
    }

    private void paintEcho(Graphics2D pen, SonarDisc disc) {
        pen.setColor(colors.accent());
        pen.setStroke(DrawingColors.stroke(2.2 / pxPerMm));
        pen.draw(arc(disc, BAR_DEG, Arc2D.OPEN));
    }

    /** Arc2D counts angles clockwise in these axes. */
    private Arc2D arc(SonarDisc disc, double widthDeg, int kind) {
        double range = Math.min(scan.rangeMm(disc.number()), SonarScan.NOTHING_MM);
        double start = -disc.axisDeg() - widthDeg / 2;
        return new Arc2D.Double(disc.xMm() - range, disc.yMm() - range, 2 * range, 2 * range, start, widthDeg, kind);
    }
}

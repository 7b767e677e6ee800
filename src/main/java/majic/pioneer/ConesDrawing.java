package majic.pioneer;

import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.util.List;
import majic.panel.Ink;

/** The cone of every sonar disc as far as it heard nothing, with a bar and a dot where the echo came from. */
final class ConesDrawing {
    private static final double CONE_DEG = 30;
    private static final double BAR_DEG = 16;
    private static final double DOT_PX = 2.5;

    private final SonarScan scan;
    private final Ink ink;
    private final double pxPerMm;

    ConesDrawing(SonarScan scan, Ink ink, double pxPerMm) {
        this.scan = scan;
        this.ink = ink;
        this.pxPerMm = pxPerMm;
    }

    /** Paints in the robot's frame, mm: first what lies below. */
    void paint(Graphics2D pen, List<SonarDisc> discs) {
        List<SonarDisc> heard =
                discs.stream().filter(disc -> scan.hasHeard(disc.number())).toList();
        heard.forEach(disc -> paintCone(pen, disc));
        heard.stream().filter(this::hasEcho).forEach(disc -> paintEcho(pen, disc));
    }

    private boolean hasEcho(SonarDisc disc) {
        return scan.rangeMm(disc.number()) < SonarScan.NOTHING_MM;
    }

    private void paintCone(Graphics2D pen, SonarDisc disc) {
        pen.setColor(ink.wash(hasEcho(disc) ? 0.16 : 0.06));
        pen.fill(arc(disc, CONE_DEG, Arc2D.PIE));
    }

    private void paintEcho(Graphics2D pen, SonarDisc disc) {
        double range = scan.rangeMm(disc.number());
        double radius = DOT_PX / pxPerMm;
        pen.setColor(ink.accent());
        pen.setStroke(Ink.stroke(2 / pxPerMm));
        pen.draw(arc(disc, BAR_DEG, Arc2D.OPEN));
        pen.fill(new Ellipse2D.Double(disc.echoX(range) - radius, disc.echoY(range) - radius, 2 * radius, 2 * radius));
    }

    /** Arc2D counts angles clockwise in these axes. */
    private Arc2D arc(SonarDisc disc, double widthDeg, int kind) {
        double range = Math.min(scan.rangeMm(disc.number()), SonarScan.NOTHING_MM);
        double start = -disc.axisDeg() - widthDeg / 2;
        return new Arc2D.Double(disc.xMm() - range, disc.yMm() - range, 2 * range, 2 * range, start, widthDeg, kind);
    }
}

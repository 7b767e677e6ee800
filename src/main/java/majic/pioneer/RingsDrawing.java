package majic.pioneer;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.Locale;
import majic.panel.Ink;

/** Rings around the turning centre at round distances, each with its number to the upper left. */
final class RingsDrawing {
    private static final double FINE_MM = 500;
    private static final double COARSE_MM = 1000;
    private static final double COARSE_BEYOND_MM = 2000;
    private static final double NUMBER_AT = Math.sqrt(0.5);

    private final Ink ink;
    private final double pxPerMm;

    RingsDrawing(Ink ink, double pxPerMm) {
        this.ink = ink;
        this.pxPerMm = pxPerMm;
    }

    /** Paints around the pen's origin, in pixels, all that fit. */
    void paint(Graphics2D pen, double reachMm) {
        double stepMm = reachMm > COARSE_BEYOND_MM ? COARSE_MM : FINE_MM;
        pen.setStroke(Ink.stroke(1));
        for (double mm = stepMm; mm <= reachMm; mm += stepMm) {
            double radius = mm * pxPerMm;
            pen.setColor(ink.grey(0.3));
            pen.draw(new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius));
            number(
                    pen,
                    String.format(Locale.ROOT, stepMm < COARSE_MM ? "%.1f m" : "%.0f m", mm / 1000),
                    radius,
                    2 - reachMm * pxPerMm);
        }
    }

    private void number(Graphics2D pen, String text, double radius, double leftmost) {
        FontMetrics metrics = pen.getFontMetrics();
        double left = Math.max(-radius * NUMBER_AT - 2 - metrics.stringWidth(text), leftmost);
        double base = -radius * NUMBER_AT - 2;
        pen.setColor(ink.grey(0.8));
        pen.drawString(text, (float) left, (float) base);
    }
}

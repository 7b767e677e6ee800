package majic.hemisson;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.RoundRectangle2D;
import majic.panel.Ink;
import org.jspecify.annotations.Nullable;

/** A bar where each infra-red sensor sits, filled the more the nearer something is, with its figure. */
final class BarsDrawing {
    private static final double LENGTH_MM = 38;
    private static final double WIDTH_MM = 13;
    private static final double GROUND_LENGTH_MM = 26;
    private static final double FIGURE_MM = 9;
    private static final double GROUND_ASIDE_MM = 7;
    private static final double FULL = 255;

    /** Where a bar begins and points: x, y in mm, direction in degrees. The ground's two stand inside, side by side. */
    private static final double[][] PLACES = {
        {64, 0, 0}, {54, -36, -40}, {54, 36, 40}, {8, -66, -90}, {8, 66, 90}, {-64, 0, 180}, {14, -10, 0}, {14, 10, 0},
    };

    private final @Nullable Proximity seen;
    private final Ink ink;
    private final double pxPerMm;

    BarsDrawing(@Nullable Proximity seen, Ink ink, double pxPerMm) {
        this.seen = seen;
        this.ink = ink;
        this.pxPerMm = pxPerMm;
    }

    /** Paints around the pen's origin, in pixels, ahead upward. */
    void paint(Graphics2D pen) {
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            paintBar(pen, sensor);
            paintFigure(pen, sensor);
        }
    }

    private void paintBar(Graphics2D pen, int sensor) {
        double[] place = PLACES[sensor];
        AffineTransform onScreen = new AffineTransform(0, -pxPerMm, -pxPerMm, 0, 0, 0);
        onScreen.translate(place[0], place[1]);
        onScreen.rotate(Math.toRadians(place[2]));
        double share = seen == null ? 0 : seen.value(sensor) / FULL;
        pen.setColor(ink.paper());
        pen.fill(onScreen.createTransformedShape(bar(sensor, 1)));
        pen.setColor(ink.accent());
        pen.fill(onScreen.createTransformedShape(bar(sensor, share)));
        pen.setColor(ink.grey(0.7));
        pen.setStroke(Ink.stroke(1.2));
        pen.draw(onScreen.createTransformedShape(bar(sensor, 1)));
    }

    private void paintFigure(Graphics2D pen, int sensor) {
        double[] place = PLACES[sensor];
        double beyond = isGround(sensor) ? -FIGURE_MM : LENGTH_MM + FIGURE_MM;
        double direction = Math.toRadians(place[2]);
        double aside = isGround(sensor) ? Math.signum(place[1]) * GROUND_ASIDE_MM : 0;
        double x = -pxPerMm * (place[1] + aside + beyond * Math.sin(direction));
        double y = -pxPerMm * (place[0] + beyond * Math.cos(direction));
        String text = seen == null ? "–" : String.valueOf(seen.value(sensor));
        FontMetrics metrics = pen.getFontMetrics();
        pen.setColor(ink.line());
        pen.drawString(text, (float) (x - metrics.stringWidth(text) / 2.0), (float) (y + metrics.getAscent() * 0.4));
    }

    private static boolean isGround(int sensor) {
        return sensor >= Proximity.GROUND_RIGHT;
    }

    private static RoundRectangle2D bar(int sensor, double filled) {
        double length = (isGround(sensor) ? GROUND_LENGTH_MM : LENGTH_MM) * filled;
        return new RoundRectangle2D.Double(0, -WIDTH_MM / 2, length, WIDTH_MM, 4, 4);
    }
}

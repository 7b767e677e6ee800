package majic.hemisson.panel;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import majic.hemisson.readings.Proximity;
import majic.panel.DrawingColors;

/**
 * A bar where each infra-red sensor sits, pointing where it looks, filled the more the nearer something is; its figure.
 */
final class BarsDrawing {
    private static final double HALF_WIDTH_MM = 6;
    private static final double GROUND_HALF_WIDTH_MM = 4.5;
    /** From the end of a bar to the middle of its figure. */
    static final double FIGURE_MM = 15;

    private static final double GROUND_FIGURE_MM = -6;
    private static final double APART_PX = 2;
    private static final double FULL = 255;

    /** Figures smaller than this cannot be read; the bars remain. */
    private static final double LEAST_PX_PER_MM = 0.55;

    private final HemissonScene view;
    private final DrawingColors colors;
    private final double pxPerMm;

    BarsDrawing(HemissonScene view, DrawingColors colors, double pxPerMm) {
        this.view = view;
        this.colors = colors;
        this.pxPerMm = pxPerMm;
    }

    /** Paints in the robot's frame, mm. */
    void paintBars(Graphics2D pen) {
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            paintBar(pen, SensorDrawing.ALL.get(sensor), view.proximity(sensor) / FULL);
        }
    }

    private void paintBar(Graphics2D pen, SensorDrawing mount, double share) {
        AffineTransform place = mount.transform();
        double half = mount.looksDown() ? GROUND_HALF_WIDTH_MM : HALF_WIDTH_MM;
        Shape frame =
                place.createTransformedShape(new RoundRectangle2D.Double(0, -half, mount.lengthMm(), 2 * half, 4, 4));
        pen.setColor(colors.paper());
        pen.fill(frame);
        pen.setColor(colors.accent());
        pen.fill(place.createTransformedShape(new Rectangle2D.Double(0, -half, mount.lengthMm() * share, 2 * half)));
        pen.setColor(colors.grey(0.75));
        pen.setStroke(DrawingColors.stroke(1.2 / pxPerMm));
        pen.draw(frame);
    }

    /** Writes the figures; around the pen's origin, in pixels, ahead upward. */
    void paintFigures(Graphics2D screen) {
        for (int sensor = 0; sensor < Proximity.SENSORS && pxPerMm >= LEAST_PX_PER_MM; sensor++) {
            paintFigure(screen, SensorDrawing.ALL.get(sensor), sensor);
        }
    }

    private void paintFigure(Graphics2D screen, SensorDrawing mount, int sensor) {
        Point2D place = mount.along(mount.looksDown() ? GROUND_FIGURE_MM : mount.lengthMm() + FIGURE_MM);
        String text = view.seen() == null ? "\u2013" : String.valueOf(view.proximity(sensor));
        FontMetrics metrics = screen.getFontMetrics();
        int width = metrics.stringWidth(text);
        double x = -pxPerMm * place.getY();
        if (mount.looksDown()) {
            x = Math.signum(x) * Math.max(Math.abs(x), width / 2.0 + APART_PX);
        }
        screen.setColor(colors.line());
        screen.drawString(
                text, (float) (x - width / 2.0), (float) (-pxPerMm * place.getX() + metrics.getAscent() * 0.4));
    }
}

package majic.aibo.panel;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.Optional;
import majic.panel.DrawingColors;

/** An LED: a ring that fills with its light, with a glow around it; a bare ring while it is dark or not known. */
final class LedDrawing {
    static final Color WHITE = new Color(0xFFE38A);
    static final Color BLUE = new Color(0x3D9BFF);
    static final Color ORANGE = new Color(0xFF9326);
    static final Color RED = new Color(0xFF4034);
    static final Color GREEN = new Color(0x3CC465);

    /** How far the light reaches, in radii. */
    static final double GLOW = 2.1;

    private final DrawingColors colors;
    private final double radius;
    private final Color ring;

    /**
     * LEDs of one size.
     *
     * @param radius in the pen's units
     * @param ring around each
     */
    LedDrawing(DrawingColors colors, double radius, Color ring) {
        this.colors = colors;
        this.radius = radius;
        this.ring = ring;
    }

    void paint(Graphics2D pen, double x, double y, Color light, Optional<Double> amount) {
        double bright = Math.max(0, Math.min(1, amount.orElse(0.0)));
        pen.setColor(colors.grey(0.22));
        pen.fill(disc(x, y, radius));
        if (bright > 0) {
            pen.setColor(DrawingColors.translucent(light, 0.4 * bright));
            pen.fill(disc(x, y, GLOW * radius));
            pen.setColor(DrawingColors.translucent(light, 0.25 + 0.75 * bright));
            pen.fill(disc(x, y, radius));
        }
        pen.setColor(ring);
        pen.setStroke(DrawingColors.stroke(0.32 * radius));
        pen.draw(disc(x, y, radius));
    }

    private static Ellipse2D disc(double x, double y, double radius) {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }
}

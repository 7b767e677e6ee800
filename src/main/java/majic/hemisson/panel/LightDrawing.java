package majic.hemisson.panel;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import majic.hemisson.readings.Proximity;
import majic.panel.DrawingColors;

/** The light on each sensor as the shade of what lies before it: sunny where it is bright, shadow where it is dark. */
final class LightDrawing {
    private static final double FAN_DEG = 48;
    private static final double BEYOND_MM = 6;
    private static final double DARK = 255;
    private static final Color SUN = new Color(0xFFC107);
    private static final Color SHADOW = Color.BLACK;
    private static final double SHADOW_OPACITY = 0.34;
    private static final double SUN_OPACITY = 0.9;

    private LightDrawing() {}

    /** Paints in the robot's frame, mm. */
    static void paint(Graphics2D pen, List<Integer> light, DrawingColors colors, double pxPerMm) {
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            SensorDrawing mount = SensorDrawing.ALL.get(sensor);
            Shape field = mount.transform().createTransformedShape(field(mount));
            pen.setColor(shade(light.get(sensor)));
            pen.fill(field);
            pen.setColor(colors.grey(0.3));
            pen.setStroke(DrawingColors.stroke(0.8 / pxPerMm));
            pen.draw(field);
        }
    }

    /** From a clear yellow for full light through hardly anything to a shadow. */
    static Color shade(int light) {
        double dark = light / DARK;
        return dark < 0.5
                ? DrawingColors.translucent(SUN, SUN_OPACITY * (1 - 2 * dark))
                : DrawingColors.translucent(SHADOW, SHADOW_OPACITY * (2 * dark - 1));
    }

    private static Shape field(SensorDrawing mount) {
        double radius = mount.lengthMm() + BEYOND_MM;
        return mount.looksDown()
                ? new RoundRectangle2D.Double(-2, -7.5, mount.lengthMm() + 4, 15, 6, 6)
                : new Arc2D.Double(-radius, -radius, 2 * radius, 2 * radius, -FAN_DEG / 2, FAN_DEG, Arc2D.PIE);
    }
}

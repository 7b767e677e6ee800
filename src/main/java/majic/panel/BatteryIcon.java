package majic.panel;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.OptionalInt;

/**
 * A battery symbol, filled according to the charge, and with a flash while charging; dashes when the charge is unknown.
 *
 * @param percent its charge, 0 to 100; empty when it is unknown
 * @param charging whether the battery is being charged
 */
public record BatteryIcon(OptionalInt percent, boolean charging) implements ScaledIcon {
    /** Below this charge the icon has the alarm colour. */
    public static final int LOW_PERCENT = 20;

    private static final int WIDTH = 24;
    private static final int HEIGHT = 12;
    private static final int INNER_WIDTH = WIDTH - 6;

    @Override
    public void paint(Component on, Graphics2D pen) {
        DrawingColors colors = DrawingColors.current();
        pen.setColor(colors.grey(0.7));
        pen.setStroke(DrawingColors.stroke(1.2));
        pen.draw(new RoundRectangle2D.Double(0.6, 0.6, WIDTH - 3.6, HEIGHT - 1.2, 4, 4));
        pen.fill(new Rectangle2D.Double(WIDTH - 2.4, 3.5, 2.2, HEIGHT - 7));
        paintCharge(pen, colors);
        if (charging) {
            paintFlash(pen, colors);
        }
    }

    private void paintCharge(Graphics2D pen, DrawingColors colors) {
        if (percent.isEmpty()) {
            pen.setColor(colors.grey(0.4));
            for (double left = 4; left < INNER_WIDTH; left += 4) {
                pen.draw(new java.awt.geom.Line2D.Double(left, HEIGHT - 3.5, left + 2, 3.5));
            }
            return;
        }
        pen.setColor(percent.getAsInt() < LOW_PERCENT ? colors.alarm() : colors.grey(0.55));
        double width = (INNER_WIDTH - 1) * percent.getAsInt() / 100.0;
        pen.fill(new Rectangle2D.Double(2.4, 2.4, width, HEIGHT - 4.8));
    }

    private static void paintFlash(Graphics2D pen, DrawingColors colors) {
        Path2D flash = new Path2D.Double();
        flash.moveTo(12, 0);
        flash.lineTo(7, 7);
        flash.lineTo(10, 7);
        flash.lineTo(8.5, 12);
        flash.lineTo(14, 5);
        flash.lineTo(11, 5);
        flash.closePath();
        pen.setColor(colors.paper());
        pen.setStroke(DrawingColors.stroke(2));
        pen.draw(flash);
        pen.setColor(colors.line());
        pen.fill(flash);
    }

    @Override
    public int width() {
        return WIDTH;
    }

    @Override
    public int height() {
        return HEIGHT;
    }
}
